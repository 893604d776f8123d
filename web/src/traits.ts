import type { Trait } from './api';

/** What an arm's numbers e tell of a quantity of its physics. */
export const valueOf = ({ middle, slope }: Trait, e: number[]): number =>
  slope.reduce((sum, s, k) => sum + s * e[k], middle);

/** The arm that has this value, and whose other quantities stay. */
export function withValue(trait: Trait, e: number[], value: number): number[] {
  const step = value - valueOf(trait, e);
  return e.map((old, k) => old + step * trait.along[k]);
}
