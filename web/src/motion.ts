import type { Environment, Motion, Track, TrackKey } from './api';
import type { Figure } from './picture';
import { frameAt, tipOf } from './shape';

export const durationOf = (motion: Motion): number =>
  Math.max(0, motion.setpoints_kpa.length - 1, ...motion.tracks.map(({ shapes }) => shapes.length - 1)) / motion.frame_rate_hz;

export type RunOptions = { replan: boolean; obstacle: boolean };

/** What of it goes with that model: the simple one has no closed loop. */
export const possible = ({ replan, obstacle }: RunOptions, model: string): RunOptions =>
  ({ replan: replan && model !== '', obstacle });

/** The track that is the most real, of those that have moved at all. */
export function mainOf({ tracks }: Motion): Track {
  const of = (wanted: TrackKey) => tracks.find(({ key, shapes }) => key === wanted && shapes.length > 0);
  return of('arm') ?? of('virtual_arm') ?? tracks[0];
}

/** Every track that is shown, as it stands at a time; the main one is painted whole. */
export function figuresAt(motion: Motion, shown: Set<TrackKey>, time_s: number, outlined = false): Figure[] {
  const main = mainOf(motion).key;
  return motion.tracks
    .filter(({ key, shapes }) => shown.has(key) && shapes.length > 0) // a run may end before its first frame
    .map(({ key, shapes, pressures_kpa }): Figure => ({
      shape: frameAt(shapes, motion.frame_rate_hz, time_s),
      pressures_kpa: frameAt(pressures_kpa, motion.frame_rate_hz, time_s),
      colour: key,
      outlined: outlined || (key !== main && shown.has(main)),
      trail: shapes.slice(0, Math.round(time_s * motion.frame_rate_hz) + 1).map(tipOf),
    }))
    .sort((a, b) => Number(a.outlined) - Number(b.outlined));
}

/** With what has come into the way by then. */
export function environmentAt(environment: Environment, { appeared }: Motion, time_s: number): Environment {
  if (!appeared || time_s < appeared.time_s) return environment;
  return { ...environment, obstacles: [...environment.obstacles, appeared.obstacle] };
}
