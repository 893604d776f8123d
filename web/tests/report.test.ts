import { describe, expect, it } from 'vitest';
import { pointsOf, ticksOf, valueAt } from '../src/report';

describe('a report’s chart', () => {
  it.each([[0, 1], [-80, 100], [0.2, 0.2034], [0, 7.2]])('has round numbers at its axis from %d to %d', (low, high) => {
    const at = ticksOf(low, high);
    expect(at.length).toBeGreaterThanOrEqual(4);
    expect(at.length).toBeLessThanOrEqual(9);
    at.forEach((value) => {
      expect(value).toBeGreaterThanOrEqual(low - 1e-9);
      expect(value).toBeLessThanOrEqual(high + 1e-9);
    });
  });
  it('knows what its edges stand for, also where they are powers', () => {
    expect(valueAt('-1 3', 0.5)).toBe(1);
    expect(valueAt('0.01 100 log', 0.5)).toBeCloseTo(1);
  });
  it('reads the corners of lines and dots', () => {
    expect(pointsOf('M1 2L3.5 -4L1e-05 6')).toEqual([[1, 2], [3.5, -4], [1e-5, 6]]);
    expect(pointsOf('M1 2h0M3 4h0')).toEqual([[1, 2], [3, 4]]);
  });
});
