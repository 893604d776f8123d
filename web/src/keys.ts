import type { Environment } from './api';
import type { App } from './app';
import { byId } from './dom';
import { centreOf, dragged, type Handle, type Point, rotated, type Selection } from './environment';
import type { Stage } from './stage';

const kStep_m = 0.002;
const kLargeStep_m = 0.01;
const kTurn_rad = 0.05;
const kPan_px = 40;
const kWays: Record<string, Point> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

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
  const by = kWays[key];
  if (by === undefined) return null;
  const handle: Handle = { of: selected, part: 'body' };
  const from: Point =
    selected === 'goal'
      ? [environment.goal.x_m, environment.goal.y_m]
      : centreOf(environment.obstacles[selected]);
  return dragged(environment, handle, from, [from[0] + step * by[0], from[1] + step * by[1]]);
}

/** On the stage, what changes the view; null: nothing. */
export function viewAct(stage: Pick<Stage, 'zoom' | 'refit' | 'pan'>, key: string): (() => void) | null {
  if (key in kWays) {
    const [x, y] = kWays[key];
    return () => stage.pan(-kPan_px * x, kPan_px * y);
  }
  return { '+': () => stage.zoom(1.25), '-': () => stage.zoom(0.8), '0': () => stage.refit() }[key] ?? null;
}

/** Undo and redo anywhere; on the stage, what changes the scene. @return whether it was such a key */
function onSceneKey(app: App, event: KeyboardEvent): boolean {
  const control = event.ctrlKey || event.metaKey;
  const letter = event.key.toLowerCase();
  if (control && (letter === 'z' || letter === 'y')) {
    event.preventDefault();
    if (letter === 'y' || event.shiftKey) app.redo();
    else app.undo();
  }
  if (control || event.target !== byId('canvas')) return false;
  const acts: Record<string, () => void> = {
    Escape: () => app.select(null),
    Delete: () => app.removeSelected(),
    Backspace: () => app.removeSelected(),
  };
  const next = keyEdit(app.environment, app.selected, event.key, event.shiftKey);
  if (next) app.edit(next);
  else acts[event.key]?.();
  return next !== null || event.key in acts;
}

/** @param edits  whether the mode changes the scene */
export function onKey(app: App, event: KeyboardEvent, edits: boolean): void {
  if (event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement) return;
  const isScenes = edits && onSceneKey(app, event);
  if (event.target !== byId('canvas') || event.ctrlKey || event.metaKey) return;
  const act = isScenes ? null : viewAct(app.stage, event.key);
  if (isScenes || act) event.preventDefault();
  act?.();
}

/** Where a key leads from the i-th of `count` tabs; undefined: nowhere. */
export function tabAfter(count: number, i: number, key: string): number | undefined {
  const to: number | undefined = { ArrowLeft: i - 1, ArrowRight: i + 1, Home: 0, End: count - 1 }[key];
  return to === undefined ? undefined : (to + count) % count;
}
