import { describe, expect, it } from 'vitest';
import { axesOf, dot, tilted, type Vector } from '../src/turning';

const cross = (a: Vector, b: Vector): Vector => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

describe('an arm in space that is turned', () => {
  it.each<[Vector]>([[[1, 0, 0]], [[-1, 0, 0]], [[0, 0, -1]], [[0, 1, 0]], [[0, 0, 0]], [[0.6, 0.8, 0]]])('keeps its shape under gravity %j', (gravity) => {
    for (const turn_rad of [0, 0.7, -2.5]) {
      for (const tilt_rad of [-Math.PI / 2, -0.3, 0, 1.2]) {
        const { right, up, toward } = axesOf({ turn_rad, tilt_rad }, gravity);
        for (const axis of [right, up, toward]) expect(dot(axis, axis)).toBeCloseTo(1);
        cross(right, up).forEach((value, i) => expect(value).toBeCloseTo(toward[i]));
        expect(dot(right, gravity)).toBeCloseTo(0);
        expect(dot(up, gravity)).toBeCloseTo(-Math.hypot(...gravity) * Math.cos(tilt_rad));
      }
    }
  });
  it('is never turned over', () => {
    expect(tilted({ turn_rad: 0, tilt_rad: 1.5 }, 0.1, 0.5)).toEqual({ turn_rad: 0.1, tilt_rad: Math.PI / 2 });
  });
});
