// Shapes as the server sends them: x_m, y_m, theta_rad of each plate, base first.

import type { Arm, Tube } from './api';
import type { Point } from './environment';

export type Pose = { x: number; y: number; theta: number };
export type Station = Pose & { gap: number };

const kTrail = 1200; // frames that a tip's trail holds: a minute

export const plateCount = (shape: number[]): number => shape.length / 3;
export const plate = (shape: number[], i: number): Pose => ({
  x: shape[3 * i],
  y: shape[3 * i + 1],
  theta: shape[3 * i + 2],
});
export const tipOf = (shape: number[]): Point => {
  const { x, y } = plate(shape, plateCount(shape) - 1);
  return [x, y];
};
/** The trail of a tip, by one frame. */
export function lengthen(trail: Point[], shape: number[]): void {
  trail.push(tipOf(shape));
  if (trail.length > kTrail) trail.shift();
}
export const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Segment that each gap belongs to, base first. */
export function segmentOfGap(arm: Arm): number[] {
  return arm.segments.flatMap((segment, i) => Array<number>(segment.gaps).fill(i));
}

/**
 * Poses along the arm: between two plates the arc of constant curvature through both that turns by
 * the difference of their headings, as limber's collision checker has it.
 */
export function centreline(shape: number[], steps = 4): Station[] {
  const stations: Station[] = [];
  const last = plateCount(shape) - 1;
  for (let gap = 0; gap < last; ++gap) {
    const a = plate(shape, gap);
    const b = plate(shape, gap + 1);
    const turn = b.theta - a.theta;
    const chord = Math.hypot(b.x - a.x, b.y - a.y);
    const begin = Math.atan2(b.y - a.y, b.x - a.x) - turn / 2;
    for (let k = 0; k <= steps; ++k) {
      const t = k / steps;
      const share = Math.abs(turn) < 1e-6 ? t : Math.sin((turn * t) / 2) / Math.sin(turn / 2);
      const along = begin + (turn * t) / 2;
      stations.push({
        x: a.x + chord * share * Math.cos(along),
        y: a.y + chord * share * Math.sin(along),
        theta: begin + turn * t,
        gap,
      });
    }
  }
  return stations;
}

/** How far from where it is predicted each plate may be: grows with its distance from the start. */
export function tubeRadii(tube: Tube, start: number[], shape: number[]): number[] {
  return tube.plate_radius_m.map((full, i) => {
    const from = plate(start, i);
    const now = plate(shape, i);
    const away = Math.hypot(now.x - from.x, now.y - from.y);
    const constant = tube.start_share >= 1 || tube.full_after_m <= 0;
    const grown = constant ? 1 : tube.start_share + (1 - tube.start_share) * Math.min(1, away / tube.full_after_m);
    return full * grown;
  });
}

/** The frame at a time; the last one holds. */
export function frameAt<T>(frames: T[], rate_hz: number, time_s: number): T {
  return frames[Math.max(0, Math.min(frames.length - 1, Math.round(time_s * rate_hz)))];
}

/** About `count` frames spread over the motion, the first and the last among them. */
export function sampled<T>(frames: T[], count: number): T[] {
  if (frames.length <= count) return frames;
  return Array.from(
    { length: count },
    (_, i) => frames[Math.round((i * (frames.length - 1)) / (count - 1))],
  );
}
