// What the animation's file holds, and how it is made.

import type { Arm, Environment, Motion, Track, TrackKey } from './api';
import { trackNames } from './names';
import { packed, unpacked } from './packing';

const kShapeUnits = [1e-4, 1e-4, 1e-3]; // m, m, rad: below a pixel
const kPressureUnits = [0.01];

export type Animation = {
  title: string;
  unit: string;
  arm: Arm;
  environment: Environment;
  frame_rate_hz: number;
  appeared: Motion['appeared'];
  setpoints_kpa: string;
  tracks: { key: TrackKey; outcome: string; shapes: string; pressures_kpa: string; clearances_m: (number | null)[] }[];
};

export function animationOf(title: string, arm: Arm, environment: Environment, motion: Motion): Animation {
  const { frame_rate_hz, appeared, setpoints_kpa, tracks } = motion;
  return {
    title, unit: arm.command.unit, environment, frame_rate_hz, appeared,
    arm: { ...arm, reach: { cell_m: 1, middles_m: [] } },
    setpoints_kpa: packed(setpoints_kpa, kPressureUnits),
    tracks: tracks.map((track) => ({
      ...track,
      shapes: packed(track.shapes, kShapeUnits),
      pressures_kpa: packed(track.pressures_kpa, kPressureUnits),
      clearances_m: track.clearances_m.map((value) => (value === null ? null : Number(value.toFixed(4)))),
    })),
  };
}

export function motionOf({ arm, frame_rate_hz, appeared, setpoints_kpa, tracks }: Animation): Motion {
  const segments = arm.segments.length;
  return {
    frame_rate_hz, appeared,
    setpoints_kpa: unpacked(setpoints_kpa, segments, kPressureUnits),
    tracks: tracks.map((track): Track => ({
      ...track,
      shapes: unpacked(track.shapes, arm.rest.length, kShapeUnits),
      pressures_kpa: unpacked(track.pressures_kpa, segments, kPressureUnits),
    })),
  };
}

const escaped = (text: string): string => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

/**
 * One file that needs no other, and nothing that is not in it. Where scripts are off there is `still`.
 * @param template  public/animation.html
 */
export function animationPage(animation: Animation, template: string, style: string, script: string, still: string): string {
  const parts: Record<string, string> = {
    TITLE: escaped(animation.title), STYLE: style, STILL: still,
    ENDS: animation.tracks.map(({ key, outcome }) => `<li>${trackNames[key]}: ${escaped(outcome)}</li>`).join(''),
    DATA: JSON.stringify(animation).replaceAll('<', '\\u003c'),
    SCRIPT: script.replaceAll('</script', '<\\/script'),
  };
  return template.replace(/@([A-Z]+)@/g, (_, name: string) => parts[name]);
}
