// Paths for the tip: drawn by hand, smoothed, and given times.

import type { Point } from './environment';
import { distance } from './shape';

const kStep_m = 0.005; // between the points of a path
const kSmooth_m = 0.04; // a hand's corners are rounded over that length
const kClosed_m = 0.03; // ends that are so near are one

const lengthOf = (points: Point[]): number =>
  points.slice(1).reduce((sum, point, i) => sum + distance(points[i], point), 0);

/** Points at equal distances along a line, its ends among them. */
export function evenly(points: Point[], step_m = kStep_m): Point[] {
  const count = Math.max(1, Math.round(lengthOf(points) / step_m));
  const apart = lengthOf(points) / count;
  const result: Point[] = [points[0]];
  let gone = 0;
  for (let i = 1; i < points.length; ++i) {
    const piece = distance(points[i - 1], points[i]);
    while (result.length < count && gone + piece >= apart * result.length) {
      const share = (apart * result.length - gone) / piece;
      result.push([0, 1].map((k) => points[i - 1][k] + share * (points[i][k] - points[i - 1][k])) as Point);
    }
    gone += piece;
  }
  return [...result, points[points.length - 1]];
}

/** What a hand has drawn, without its jitter; closed where it comes back to its start. */
export function pathOf(drawn: Point[]): Point[] {
  const closes = drawn.length > 2 && distance(drawn[0], drawn[drawn.length - 1]) < kClosed_m && lengthOf(drawn) > 4 * kClosed_m;
  const points = evenly(closes ? [...drawn, drawn[0]] : drawn);
  const around = Math.round(kSmooth_m / kStep_m / 2);
  const last = points.length - 1;
  const at = (i: number): Point => points[closes ? ((i % last) + last) % last : Math.max(0, Math.min(last, i))];
  return points.map((_, i): Point => {
    const reach = closes ? around : Math.min(around, i, last - i); // open ends stay
    const near = Array.from({ length: 2 * reach + 1 }, (_, k) => at(i + k - reach));
    return [0, 1].map((k) => near.reduce((sum, point) => sum + point[k], 0) / near.length) as Point;
  });
}

/** A circle or an eight that most arms reach, about a point. */
export function figureOf(kind: 'circle' | 'eight', [x, y]: Point, radius_m: number): Point[] {
  return Array.from({ length: 121 }, (_, i): Point => {
    const turn = (2 * Math.PI * i) / 120;
    return kind === 'circle'
      ? [x + radius_m * Math.cos(turn), y + radius_m * Math.sin(turn)]
      : [x + radius_m * Math.sin(turn) * Math.cos(turn), y + radius_m * Math.sin(turn)];
  });
}

/** time_s, x_m, y_m of each point, at an even speed. */
export function timed(points: Point[], seconds: number): number[] {
  const total = lengthOf(points);
  let gone = 0;
  return points.flatMap((point, i) => {
    gone += i === 0 ? 0 : distance(points[i - 1], point);
    return [(seconds * gone) / total, ...point];
  });
}

/** For `limber execute --track`. */
export function csvOf(path: number[]): string {
  const rows = Array.from({ length: path.length / 3 }, (_, i) =>
    [path[3 * i].toFixed(4), path[3 * i + 1].toFixed(5), path[3 * i + 2].toFixed(5)].join(','));
  return ['time_s,x_m,y_m', ...rows, ''].join('\n');
}
