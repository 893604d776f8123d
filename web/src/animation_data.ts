// What the animation's file holds, and how it is made.

import type { Arm, Environment, Motion, Track, TrackKey } from './api';
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

/** One file that needs no other, and nothing that is not in it. Where scripts are off there is `still`. */
export function animationPage(animation: Animation, style: string, script: string, still: string): string {
  const json = JSON.stringify(animation).replaceAll('<', '\\u003c');
  const ends = animation.tracks.map(({ key, outcome }) => `<li>${key}: ${escaped(outcome)}</li>`).join('');
  return `<!doctype html>
<html lang="en" class="animation">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<title>${escaped(animation.title)}</title>
<style>${style}</style>
</head>
<body>
<header><h1>${escaped(animation.title)} <span>limber</span></h1></header>
<main><div id="stage">${still}</div><section id="panel" aria-label="Time and plots"><ul>${ends}</ul></section></main>
<script type="application/json" id="data">${json}</script>
<script>${script.replaceAll('</script', '<\\/script')}</script>
</body>
</html>
`;
}
