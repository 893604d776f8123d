import type { Trait } from './api';

/** What an arm's numbers e tell of a quantity of its physics. */
export const valueOf = ({ middle, slope }: Trait, e: number[]): number =>
  slope.reduce((sum, s, k) => sum + s * e[k], middle);

/** The arm that has this value, while nothing else of it changes. */
export function withValue(trait: Trait, e: number[], value: number): number[] {
  const told = trait.along.reduce((sum, a, k) => sum + a * trait.slope[k], 0); // nearly 1
  const step = (value - valueOf(trait, e)) / told;
  return e.map((old, k) => old + step * trait.along[k]);
}
