import type { Environment } from './api';
import { centreOf, type Point, type Selection } from './environment';

/** Where the page looks: `x`, `y` [m] in the middle of `width` × `height` pixels. */
export type Camera = { x: number; y: number; m_per_px: number; width: number; height: number };

const kMin_m_per_px = 1e-4;
const kMax_m_per_px = 0.02;

export const toWorld = (c: Camera, [px, py]: Point): Point => [
  c.x + (px - c.width / 2) * c.m_per_px,
  c.y - (py - c.height / 2) * c.m_per_px,
];
export const toPixels = (c: Camera, [x, y]: Point): Point => [
  c.width / 2 + (x - c.x) / c.m_per_px,
  c.height / 2 - (y - c.y) / c.m_per_px,
];

/** Closer for factors above 1; the point under the pointer stays where it is. */
export function zoomed(c: Camera, factor: number, at: Point): Camera {
  const m_per_px = Math.min(kMax_m_per_px, Math.max(kMin_m_per_px, c.m_per_px / factor));
  const [x, y] = toWorld(c, at);
  const [nx, ny] = toWorld({ ...c, m_per_px }, at);
  return { ...c, m_per_px, x: c.x + x - nx, y: c.y + y - ny };
}

export function panned(c: Camera, dx_px: number, dy_px: number): Camera {
  return { ...c, x: c.x - dx_px * c.m_per_px, y: c.y + dy_px * c.m_per_px };
}

/** All of a box, with some room about it. */
export function fitted(c: Camera, low: Point, high: Point): Camera {
  const kRoom = 1.12;
  const m_per_px = Math.max((high[0] - low[0]) / c.width, (high[1] - low[1]) / c.height) * kRoom;
  return { ...c, m_per_px, x: (low[0] + high[0]) / 2, y: (low[1] + high[1]) / 2 };
}

/** Distance of grid lines: 1, 2 or 5 times a power of ten, at least so many pixels apart. */
export function gridStep_m(c: Camera, least_px = 72): number {
  const least = least_px * c.m_per_px;
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5, 10].find((k) => k * power >= least) ?? 10);
}

/** Numbers along the picture's lower and right edge, clear of the corners. [px] */
export function axisLabels(c: Camera): { axis: 'x' | 'y'; at: number; text: string }[] {
  const step = gridStep_m(c);
  const digits = Math.max(0, -Math.floor(Math.log10(step)));
  const [left, top] = toWorld(c, [0, 0]);
  const [right, bottom] = toWorld(c, [c.width, c.height]);
  const steps = (from: number, to: number) => {
    const first = Math.ceil(from / step);
    return Array.from({ length: Math.max(0, Math.floor(to / step) - first + 1) }, (_, i) => (first + i) * step);
  };
  const rounded = (px: number) => Number(px.toFixed(1));
  return [
    ...steps(left, right).map((x) => ({ axis: 'x' as const, at: rounded(toPixels(c, [x, 0])[0]), text: `${x.toFixed(digits)} m` }))
      .filter(({ at }) => at > 56 && at < c.width - 28),
    ...steps(bottom, top).map((y) => ({ axis: 'y' as const, at: rounded(toPixels(c, [0, y])[1]), text: y.toFixed(digits) }))
      .filter(({ at }) => at > 64 && at < c.height - 28),
  ];
}

/** Numbers of obstacles, as messages name them, in their middles; those of a selected polygon's corners above these. [px] */
export function thingLabels(c: Camera, environment: Environment | null, selected: Selection): { at: Point; text: string }[] {
  const kAbove_px = 15; // clear of the corner's handle
  const label = (point: Point, i: number, above_px = 0) => {
    const [x, y] = toPixels(c, point);
    return { at: [Math.round(x), Math.round(y - above_px)] as Point, text: String(i) };
  };
  const obstacles = environment?.obstacles ?? [];
  const chosen = typeof selected === 'number' ? obstacles[selected] : undefined;
  const corners = chosen && 'polygon' in chosen ? chosen.polygon : [];
  return [...obstacles.map((obstacle, i) => label(centreOf(obstacle), i)), ...corners.map((corner, i) => label(corner, i, kAbove_px))];
}
