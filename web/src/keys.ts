import { centreOf, dragged, type Handle, type Point, rotated, type Selection } from './environment';
import type { Environment } from './api';

const kStep_m = 0.002;
const kLargeStep_m = 0.01;
const kTurn_rad = 0.05;

/** What a key on the stage does to what is selected; null: nothing. */
export function keyEdit(
  environment: Environment,
  selected: Selection,
  key: string,
  shift: boolean,
): Environment | null {
  if (selected === null) return null;
  if (key === '[' || key === ']') return rotated(environment, selected, key === '[' ? kTurn_rad : -kTurn_rad);
  const step = shift ? kLargeStep_m : kStep_m;
  const ways: Record<string, Point> = {
    ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step],
  };
  const by = ways[key];
  if (by === undefined) return null;
  const handle: Handle = { of: selected, part: 'body' };
  const from: Point =
    selected === 'goal'
      ? [environment.goal.x_m, environment.goal.y_m]
      : centreOf(environment.obstacles[selected]);
  return dragged(environment, handle, from, [from[0] + by[0], from[1] + by[1]]);
}
