import { describe, expect, it } from 'vitest';
import type { Point } from '../src/environment';
import { csvOf, evenly, figureOf, pathOf, timed } from '../src/path';
import { distance } from '../src/shape';

const line: Point[] = [[0, 0], [0.1, 0], [0.1, 0.2]];

describe('a path', () => {
  it('has its points at equal distances, and keeps its ends', () => {
    const points = evenly(line, 0.01);
    expect(points).toHaveLength(31);
    expect(points[0]).toEqual([0, 0]);
    expect(points[30]).toEqual([0.1, 0.2]);
    expect(points[5][0]).toBeCloseTo(0.05);
    expect(points[20][1]).toBeCloseTo(0.1);
  });
  it('is smooth where the hand was not, and open ends stay', () => {
    const shaky = Array.from({ length: 101 }, (_, i): Point => [i * 0.003, i % 2 ? 0.002 : -0.002]);
    const points = pathOf(shaky);
    expect(points[0]).toEqual(shaky[0]);
    expect(points[points.length - 1]).toEqual(shaky[100]);
    points.slice(5, -5).forEach(([, y]) => expect(Math.abs(y)).toBeLessThan(0.001));
  });
  it('is closed where the hand comes back to its start', () => {
    const points = pathOf(figureOf('circle', [0.4, 0.2], 0.1).slice(0, -4));
    expect(points[0]).toEqual(points[points.length - 1]);
    points.forEach((point) => expect(distance(point, [0.4, 0.2])).toBeCloseTo(0.1, 1));
  });
  it('is run at an even speed', () => {
    const path = timed(line, 30);
    expect(path.map((value) => Number(value.toFixed(6)))).toEqual([0, 0, 0, 10, 0.1, 0, 30, 0.1, 0.2]);
    expect(csvOf(path)).toBe('time_s,x_m,y_m\n0.0000,0.00000,0.00000\n10.0000,0.10000,0.00000\n30.0000,0.10000,0.20000\n');
  });
});
