// Edits of environments: pure functions from one environment to the next.

import type { Environment, Goal, Obstacle } from './api';

export type Point = [number, number];
/** What is selected: the goal, or an obstacle by its index. */
export type Selection = 'goal' | number | null;
/** What a pointer drags: a whole thing, or one of its handles. */
export type Handle = { of: Exclude<Selection, null>; part: 'body' | 'size' | 'turn' | number };

const kSmallest_m = 0.005; // an obstacle can still be hit with a finger
const kTurnHandle_m = 0.05; // beyond what it turns

/** To the millimetre: files stay readable. */
export const mm = (value_m: number): number => Math.round(value_m * 1000) / 1000;
const hundredth = (value_rad: number): number => Math.round(value_rad * 100) / 100;
const add = ([x, y]: Point, [dx, dy]: Point): Point => [mm(x + dx), mm(y + dy)];
const turned = ([x, y]: Point, angle: number): Point => [
  x * Math.cos(angle) - y * Math.sin(angle),
  x * Math.sin(angle) + y * Math.cos(angle),
];

export function kindOf(obstacle: Obstacle): string {
  return Object.keys(obstacle)[0];
}

export function centreOf(obstacle: Obstacle): Point {
  if ('circle' in obstacle) return [obstacle.circle.x_m, obstacle.circle.y_m];
  if ('rectangle' in obstacle) return [obstacle.rectangle.x_m, obstacle.rectangle.y_m];
  const n = obstacle.polygon.length;
  return [0, 1].map((k) => obstacle.polygon.reduce((sum, p) => sum + p[k], 0) / n) as Point;
}

/** Corners, counter-clockwise for a rectangle; of a circle many. */
export function outlineOf(obstacle: Obstacle): Point[] {
  if ('polygon' in obstacle) return obstacle.polygon;
  const centre = centreOf(obstacle);
  const about = ([x, y]: Point): Point => [centre[0] + x, centre[1] + y];
  if ('rectangle' in obstacle) {
    const { width_m: w, height_m: h, angle_rad } = obstacle.rectangle;
    const corners: Point[] = [[-w, -h], [w, -h], [w, h], [-w, h]];
    return corners.map(([x, y]) => about(turned([x / 2, y / 2], angle_rad)));
  }
  const kSides = 64;
  return Array.from({ length: kSides }, (_, i) =>
    about(turned([obstacle.circle.radius_m, 0], (2 * Math.PI * i) / kSides)),
  );
}

export function isInside([x, y]: Point, outline: Point[]): boolean {
  let inside = false;
  outline.forEach(([ax, ay], i) => {
    const [bx, by] = outline[(i + 1) % outline.length];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
  });
  return inside;
}

/** Handles of what is selected, where they are drawn and hit. */
export function handlesOf(environment: Environment, selected: Selection): [Handle, Point][] {
  if (selected === null) return [];
  if (selected === 'goal') {
    const { x_m, y_m, theta_rad, position_tolerance_m: r } = environment.goal;
    const handles: [Handle, Point][] = [[{ of: 'goal', part: 'size' }, [x_m, y_m - r]]];
    if (theta_rad !== undefined) {
      const [dx, dy] = turned([r + kTurnHandle_m, 0], theta_rad);
      handles.push([{ of: 'goal', part: 'turn' }, [x_m + dx, y_m + dy]]);
    }
    return handles;
  }
  const obstacle = environment.obstacles[selected];
  if (obstacle === undefined) return [];
  const [x, y] = centreOf(obstacle);
  if ('circle' in obstacle) {
    return [[{ of: selected, part: 'size' }, [x + obstacle.circle.radius_m, y]]];
  }
  if ('rectangle' in obstacle) {
    const { width_m, angle_rad } = obstacle.rectangle;
    const [dx, dy] = turned([width_m / 2 + kTurnHandle_m, 0], angle_rad);
    return [
      [{ of: selected, part: 'size' }, outlineOf(obstacle)[2]],
      [{ of: selected, part: 'turn' }, [x + dx, y + dy]],
    ];
  }
  return obstacle.polygon.map((p, i) => [{ of: selected, part: i }, p]);
}

/**
 * What lies under a point: handles of the selection first, then the goal, then the last obstacle. A
 * finger reaches far: a handle is meant where it is nearer than the middle of what it belongs to.
 */
export function hit(
  environment: Environment,
  selected: Selection,
  at: Point,
  reach_m: number,
): Handle | null {
  const { goal, obstacles } = environment;
  const away = ([x, y]: Point) => Math.hypot(x - at[0], y - at[1]);
  const near = (point: Point, radius: number) => away(point) <= radius;
  for (const [handle, point] of handlesOf(environment, selected)) {
    const middle: Point = handle.of === 'goal' ? [goal.x_m, goal.y_m] : centreOf(obstacles[handle.of]);
    if (near(point, reach_m) && away(point) < away(middle)) return handle;
  }
  if (near([goal.x_m, goal.y_m], Math.max(goal.position_tolerance_m, reach_m))) {
    return { of: 'goal', part: 'body' };
  }
  for (let i = obstacles.length - 1; i >= 0; --i) {
    if (isInside(at, outlineOf(obstacles[i])) || near(centreOf(obstacles[i]), reach_m)) {
      return { of: i, part: 'body' };
    }
  }
  return null;
}

export function withObstacle(environment: Environment, i: number, obstacle: Obstacle): Environment {
  const obstacles = environment.obstacles.map((old, k) => (k === i ? obstacle : old));
  return { ...environment, obstacles };
}

function moved(obstacle: Obstacle, by: Point): Obstacle {
  if ('polygon' in obstacle) return { polygon: obstacle.polygon.map((p) => add(p, by)) };
  const [x_m, y_m] = add(centreOf(obstacle), by);
  return 'circle' in obstacle
    ? { circle: { ...obstacle.circle, x_m, y_m } }
    : { rectangle: { ...obstacle.rectangle, x_m, y_m } };
}

function reshaped(obstacle: Obstacle, part: Handle['part'], to: Point): Obstacle {
  const [x, y] = centreOf(obstacle);
  const from: Point = [to[0] - x, to[1] - y];
  if ('circle' in obstacle) {
    const radius_m = Math.max(kSmallest_m, mm(Math.hypot(...from)));
    return { circle: { ...obstacle.circle, radius_m } };
  }
  if ('polygon' in obstacle) {
    return { polygon: obstacle.polygon.map((p, i) => (i === part ? add(to, [0, 0]) : p)) };
  }
  if (part === 'turn') {
    const angle_rad = hundredth(Math.atan2(from[1], from[0]));
    return { rectangle: { ...obstacle.rectangle, angle_rad } };
  }
  const [across, up] = turned(from, -obstacle.rectangle.angle_rad).map((half) =>
    Math.max(kSmallest_m, mm(2 * Math.abs(half))),
  );
  return { rectangle: { ...obstacle.rectangle, width_m: across, height_m: up } };
}

function reshapedGoal(goal: Goal, part: Handle['part'], to: Point): Goal {
  const from: Point = [to[0] - goal.x_m, to[1] - goal.y_m];
  return part === 'turn'
    ? { ...goal, theta_rad: hundredth(Math.atan2(from[1], from[0])) }
    : { ...goal, position_tolerance_m: Math.max(kSmallest_m, mm(Math.hypot(...from))) };
}

/** `begin`, the handle having moved from one point to another. */
export function dragged(begin: Environment, handle: Handle, from: Point, to: Point): Environment {
  const by: Point = [to[0] - from[0], to[1] - from[1]];
  if (handle.of === 'goal') {
    const [x_m, y_m] = add([begin.goal.x_m, begin.goal.y_m], by);
    const goal =
      handle.part === 'body' ? { ...begin.goal, x_m, y_m } : reshapedGoal(begin.goal, handle.part, to);
    return { ...begin, goal };
  }
  const old = begin.obstacles[handle.of];
  return withObstacle(
    begin,
    handle.of,
    handle.part === 'body' ? moved(old, by) : reshaped(old, handle.part, to),
  );
}

/** What keys do: a turn about its middle. */
export function rotated(environment: Environment, selected: Selection, by_rad: number): Environment {
  if (selected === null) return environment;
  if (selected === 'goal') {
    const { theta_rad } = environment.goal;
    if (theta_rad === undefined) return environment;
    return { ...environment, goal: { ...environment.goal, theta_rad: hundredth(theta_rad + by_rad) } };
  }
  const obstacle = environment.obstacles[selected];
  if ('circle' in obstacle) return environment;
  if ('rectangle' in obstacle) {
    const angle_rad = hundredth(obstacle.rectangle.angle_rad + by_rad);
    return withObstacle(environment, selected, { rectangle: { ...obstacle.rectangle, angle_rad } });
  }
  const [x, y] = centreOf(obstacle);
  const polygon = obstacle.polygon.map((p) => add([x, y], turned([p[0] - x, p[1] - y], by_rad)));
  return withObstacle(environment, selected, { polygon });
}

export function newObstacle(kind: string, [x, y]: Point): Obstacle {
  const [x_m, y_m] = add([x, y], [0, 0]);
  if (kind === 'circle') return { circle: { x_m, y_m, radius_m: 0.04 } };
  if (kind === 'rectangle') {
    return { rectangle: { x_m, y_m, width_m: 0.1, height_m: 0.06, angle_rad: 0 } };
  }
  const corners: Point[] = [[0.05, -0.03], [0, 0.06], [-0.05, -0.03]];
  return { polygon: corners.map((corner) => add([x_m, y_m], corner)) };
}

export function added(environment: Environment, obstacle: Obstacle): Environment {
  return { ...environment, obstacles: [...environment.obstacles, obstacle] };
}

/** A corner more, in the middle of the longest edge. */
export function withCorner(polygon: Point[]): Point[] {
  const after = (i: number) => polygon[(i + 1) % polygon.length];
  const lengths = polygon.map(([x, y], i) => Math.hypot(after(i)[0] - x, after(i)[1] - y));
  const i = lengths.indexOf(Math.max(...lengths));
  const middle: Point = [mm((polygon[i][0] + after(i)[0]) / 2), mm((polygon[i][1] + after(i)[1]) / 2)];
  return [...polygon.slice(0, i + 1), middle, ...polygon.slice(i + 1)];
}

export function removed(environment: Environment, i: number): Environment {
  return { ...environment, obstacles: environment.obstacles.filter((_, k) => k !== i) };
}

/** What is selected after a step back or forth: the same obstacle, wherever it stands in the list. */
export function stillSelected(selected: Selection, before: Environment, after: Environment): Selection {
  if (typeof selected !== 'number') return selected;
  const same = after.obstacles.indexOf(before.obstacles[selected]);
  if (same >= 0) return same;
  return after.obstacles.length === before.obstacles.length ? selected : null; // it was changed, or has gone
}
