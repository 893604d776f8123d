import { expect, test } from 'vitest';
import type { Trait } from '../src/api';
import { valueOf, withValue } from '../src/traits';

const trait = (middle: number, slope: number[], along: number[]): Trait =>
  ({ text: 'load', unit: ' g', of_arm_file: 0, low: 0, high: 80, middle, slope, along });

test('a quantity is changed alone', () => {
  // Slopes that are not orthogonal; the directions are the columns of their inverse.
  const load = trait(40, [20, 0], [0.05, -0.05]);
  const friction = trait(0.25, [0.1, 0.1], [0, 10]);
  const e = [0.5, -1];
  expect(valueOf(load, e)).toBe(50);
  const heavier = withValue(load, e, 70);
  expect(valueOf(load, heavier)).toBeCloseTo(70);
  expect(valueOf(friction, heavier)).toBeCloseTo(valueOf(friction, e));
  expect(withValue(friction, e, valueOf(friction, e))).toEqual(e);
});
