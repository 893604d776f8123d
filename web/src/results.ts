// What the Results panel shows: an experiment's table, errors over horizons, a recording's coverage.

import type { Arm, Coverage, Experiment, Horizons, Row, TrialRun } from './api';
import { button, h, svg } from './dom';
import type { RunOptions } from './motion';

const kWidth = 308;
const kHeight = 150;
const kLeft = 34;
const kTop = 8;
const kFoot = 20;
const kMap = 92; // px, a side of a coverage map

const curveNames: Record<string, [swatch: string, name: string]> = {
  network: ['network', 'Network'],
  no_load: ['simple', 'Simple model'],
  hold: ['hold', 'Hold the pose'],
};

/** What a row has beside its environment, where it is not as usual. */
export function wayOf({ model, planner, controller, disturbance }: Row): string {
  return [
    model === 'network' ? 'network' : 'simple model',
    planner === 'default' ? '' : planner,
    controller === 'open' ? '' : controller,
    disturbance,
  ].filter((word) => word !== '').join(', ');
}

/** How Play moves a row's plans, and what of the row it leaves out. */
export function playOf({ controller, disturbance }: Row): { options: RunOptions; leftOut: string } {
  const others = disturbance.split(',').filter((kind) => kind !== '' && kind !== 'obstacle');
  return {
    options: { replan: controller === 'replan', obstacle: disturbance.split(',').includes('obstacle') },
    leftOut: [...(['open', 'replan'].includes(controller) ? [] : [controller]), ...others].join(', '),
  };
}

/** How a run ended. */
export function endOf(run: TrialRun): string {
  if (run.status !== 'solved') return 'no plan';
  const cm = run.distance_to_goal_cm === null ? '' : `, ${run.distance_to_goal_cm.toFixed(2)} cm`;
  if (run.goal_reached === null && run.collided === null) return 'not executed';
  return `${run.collided ? 'collides' : run.goal_reached ? 'arrives' : run.stopped_ahead ? 'stops' : 'misses'}${cm}`;
}

const number = (value: number | null | undefined): string => (value == null ? '–' : value.toFixed(2));

/** Rows to press: each opens into its runs. @param open  the row that is open */
export function experimentTable(
  { rows }: Experiment,
  open: number | null,
  runs: TrialRun[] | null,
  toggle: (row: number) => void,
  play: (run: TrialRun) => void,
): HTMLElement {
  const head = ['Environment', 'Arrive', 'Collide', 'Miss, cm'].map((text) => h('th', { scope: 'col' }, text));
  return h('table', { class: 'experiment' },
    h('caption', {}, 'Runs that arrive and collide; median distance to the goal'),
    h('thead', {}, h('tr', {}, ...head)),
    h('tbody', {}, ...rows.flatMap((row, i) => {
      const press = button(row.environment, () => toggle(i), { 'aria-expanded': String(open === i) });
      const line = h('tr', {}, h('th', { scope: 'row' }, press, h('small', {}, wayOf(row))),
        h('td', {}, `${row.reached}/${row.trials}`), h('td', {}, String(row.collided)),
        h('td', {}, number(row.distance_to_goal_cm?.median)));
      return open === i ? [line, runsOf(runs, play)] : [line];
    })));
}

function runsOf(runs: TrialRun[] | null, play: (run: TrialRun) => void): HTMLElement {
  const list = runs === null
    ? h('p', { class: 'hint' }, 'Reading …')
    : h('ul', { class: 'runs' }, ...runs.map((run, k) => h('li', {},
        button(`${k} · ${endOf(run)}`, () => play(run), { disabled: run.plan === null, title: 'Play this plan' }))));
  return h('tr', {}, h('td', { colspan: 4 }, list));
}

/** Mean tip error over the frames between corrections, both axes in powers. */
export function horizonChart({ frames, tip_error_cm }: Horizons, rate_hz: number): HTMLElement {
  const curves = Object.entries(tip_error_cm).sort(([a]) => (a === 'network' ? 1 : -1));
  const values = curves.flatMap(([, curve]) => curve).filter((value): value is number => value !== null && value > 0);
  const low = Math.floor(Math.log10(Math.min(1, ...values)));
  const high = Math.max(low + 1, Math.ceil(Math.log10(Math.max(0.01, ...values))));
  const last = Math.log2(Math.max(2, frames[frames.length - 1]));
  const x = (count: number) => kLeft + (Math.log2(count) / last) * (kWidth - kLeft - 4);
  const y = (cm: number) => kTop + ((high - Math.log10(Math.max(10 ** low, cm))) / (high - low)) * (kHeight - kFoot - kTop);
  const path = (curve: (number | null)[]) => curve.map((cm, k) =>
    cm === null ? '' : `${k === 0 || curve[k - 1] === null ? 'M' : 'L'}${x(frames[k]).toFixed(1)} ${y(cm).toFixed(1)}`).join('');
  const powers = Array.from({ length: high - low + 1 }, (_, k) => 10 ** (low + k));
  const shown = frames.filter((_, k) => k % 3 === 0);
  const time = (count: number) => (count / rate_hz < 10 ? `${Number((count / rate_hz).toPrecision(2))} s` : `${Math.round(count / rate_hz)} s`);
  const picture = svg('svg', { viewBox: `0 0 ${kWidth} ${kHeight}`, role: 'img', 'aria-label': 'Mean tip error in cm over the time since the last correction' },
    ...powers.flatMap((cm) => [
      svg('line', { class: 'tick', x1: kLeft, x2: kWidth, y1: y(cm), y2: y(cm) }),
      svg('text', { x: kLeft - 5, y: y(cm) + 3.5, 'text-anchor': 'end' }, String(Number(cm.toPrecision(1)))),
    ]),
    ...shown.map((count) => svg('text', { x: x(count), y: kHeight - 5, 'text-anchor': x(count) > kWidth - 20 ? 'end' : 'middle' }, time(count))),
    ...curves.map(([key, curve]) => svg('path', { class: `line ${curveNames[key]?.[0]}`, d: path(curve) })));
  const lines = curves.map(([key, curve]) => h('tr', {},
    h('th', { scope: 'row' }, h('i', { class: `swatch ${curveNames[key]?.[0]}` }), ` ${curveNames[key]?.[1] ?? key}`),
    h('td', {}, number(curve[0])), h('td', {}, number(curve[curve.length - 1]))));
  return h('figure', {}, picture as unknown as HTMLElement,
    h('table', {}, h('caption', {}, 'Mean tip error, cm'),
      h('thead', {}, h('tr', {}, h('td', {}), h('th', { scope: 'col' }, '1 frame'), h('th', { scope: 'col' }, 'never corrected'))),
      h('tbody', {}, ...lines.reverse())));
}

/** The share of a map's cells that the recording has been in. */
export const coveredShare = (frames: number[]): number => frames.filter((count) => count > 0).length / frames.length;

/** A map for each pair of segments: the darker, the more often the recording was there. */
export function coverageMaps({ cells, pairs }: Coverage, { segments, command }: Arm): HTMLElement {
  const size = kMap / cells;
  const range = (i: number) => `${segments[i].lower_kpa.toFixed(0)} … ${segments[i].upper_kpa.toFixed(0)} ${command.unit}`;
  return h('div', { class: 'maps' }, ...pairs.map(({ segments: [i, j], frames }) => {
    const most = Math.log1p(Math.max(1, ...frames));
    const percent = `${Math.round(100 * coveredShare(frames))} %`;
    const picture = svg('svg', { viewBox: `0 0 ${kMap} ${kMap}`, role: 'img', 'aria-label': `Segment ${i} across, ${range(i)}; segment ${j} up, ${range(j)}: ${percent} of the cells are covered` },
      svg('rect', { class: 'map', width: kMap, height: kMap }),
      ...frames.flatMap((count, at) => count === 0 ? [] : [svg('rect', {
        class: 'cell', width: size + 0.1, height: size + 0.1, x: (at % cells) * size, y: kMap - size * (Math.floor(at / cells) + 1),
        opacity: (0.2 + 0.8 * (Math.log1p(count) / most)).toFixed(2),
      })]));
    return h('figure', {}, picture as unknown as HTMLElement, h('figcaption', {}, `${i} across, ${j} up: ${percent}`));
  }));
}
