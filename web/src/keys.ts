import type { Environment } from './api';
import type { App } from './app';
import { byId } from './dom';
import { centreOf, dragged, type Handle, type Point, rotated, type Selection } from './environment';

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

/** Undo and redo anywhere; on the stage, what changes the scene and the view. */
export function onKey(app: App, event: KeyboardEvent): void {
  if (event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement) return;
  const control = event.ctrlKey || event.metaKey;
  const letter = event.key.toLowerCase();
  if (control && (letter === 'z' || letter === 'y')) {
    event.preventDefault();
    if (letter === 'y' || event.shiftKey) app.redo();
    else app.undo();
  }
  if (control || event.target !== byId('canvas')) return;
  const acts: Record<string, () => void> = {
    Escape: () => app.select(null),
    Delete: () => app.removeSelected(),
    Backspace: () => app.removeSelected(),
    '+': () => app.stage.zoom(1.25),
    '-': () => app.stage.zoom(0.8),
    '0': () => app.stage.refit(),
  };
  const next = keyEdit(app.environment, app.selected, event.key, event.shiftKey);
  if (next || acts[event.key]) event.preventDefault();
  if (next) app.edit(next);
  else acts[event.key]?.();
}

/** Where a key leads from the i-th of `count` tabs; undefined: nowhere. */
export function tabAfter(count: number, i: number, key: string): number | undefined {
  const to: number | undefined = { ArrowLeft: i - 1, ArrowRight: i + 1, Home: 0, End: count - 1 }[key];
  return to === undefined ? undefined : (to + count) % count;
}
