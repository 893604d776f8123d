// How an arm in space is looked at: turned about the vertical and tilted, without perspective, so that lengths compare.

export type Vector = [x: number, y: number, z: number];
export type View = { turn_rad: number; tilt_rad: number };

export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vector, b: Vector): Vector => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a: Vector, by: number): Vector => [a[0] * by, a[1] * by, a[2] * by];
const sum = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const unit = (a: Vector): Vector => scaled(a, 1 / Math.hypot(...a));

/** What points right, up and at the viewer. @param gravity  where things fall; zero: −z */
export function axesOf(view: View, gravity: Vector): { right: Vector; up: Vector; toward: Vector } {
  const vertical = Math.hypot(...gravity) > 0 ? unit(scaled(gravity, -1)) : ([0, 0, 1] as Vector);
  const across: Vector = Math.abs(vertical[1]) < 0.9 ? [0, 1, 0] : [0, 0, 1];
  const side = unit(sum(across, scaled(vertical, -dot(across, vertical))));
  const front = cross(side, vertical);
  const right = sum(scaled(side, Math.cos(view.turn_rad)), scaled(front, Math.sin(view.turn_rad)));
  const level = cross(right, vertical);
  return {
    right,
    up: sum(scaled(vertical, Math.cos(view.tilt_rad)), scaled(level, -Math.sin(view.tilt_rad))),
    toward: sum(scaled(level, Math.cos(view.tilt_rad)), scaled(vertical, Math.sin(view.tilt_rad))),
  };
}

/** Never past straight from above or below. */
export const tilted = ({ turn_rad, tilt_rad }: View, turn: number, tilt: number): View =>
  ({ turn_rad: turn_rad + turn, tilt_rad: Math.max(-Math.PI / 2, Math.min(tilt_rad + tilt, Math.PI / 2)) });
