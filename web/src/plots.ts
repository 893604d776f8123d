// Charts over time in plain SVG, with a cursor that the slider moves, and that a click moves.

import type { Motion, Track, TrackKey } from './api';
import { h, svg } from './dom';
import type { Goal } from './api';
import { trackNames } from './names';
import { distance, tipOf } from './shape';

type Series = { name: string; swatch: string; values: (number | null)[] };
export type Chart = { title: string; unit: string; series: Series[] };

const kWidth = 308;
const kHeight = 84;
const kLeft = 34; // of the axis' numbers
const kFoot = 7; // half of a number's height

/** What there is to see of a motion; `main` is the track that is the most real. */
export function chartsOf(motion: Motion, main: Track, goal: Goal, unit: string): Chart[] {
  const others = motion.tracks.filter((track) => track !== main);
  const predicted = others.find(({ key }) => key === 'network') ?? others.find(({ key }) => key === 'simple');
  const segments = motion.setpoints_kpa[0]?.length ?? 0;
  const column = (rows: number[][], i: number) => rows.map((row) => row[i]);
  const cm = (values: (number | null)[]) => values.map((value) => (value === null ? null : 100 * value));
  const series = (track: Track, values: (number | null)[]): Series => ({
    name: trackNames[track.key], swatch: track.key, values,
  });
  const charts: Chart[] = Array.from({ length: segments }, (_, i) => ({
    title: `Pressure of segment ${i}`,
    unit,
    series: [
      { name: 'set', swatch: 'set', values: column(motion.setpoints_kpa, i) },
      ...(predicted ? [series(predicted, column(predicted.pressures_kpa, i))] : []),
      series(main, column(main.pressures_kpa, i)),
    ],
  }));
  charts.push({
    title: `Tip from the ${trackNames[main.key].replace(/^The /, '').toLowerCase()}’s`,
    unit: 'cm',
    series: others.map((track) => series(track, cm(main.shapes.slice(0, track.shapes.length).map((shape, k) =>
      distance(tipOf(shape), tipOf(track.shapes[k])))))),
  }, {
    title: 'Tip from the goal’s centre',
    unit: 'cm',
    series: motion.tracks.map((track) => series(track, cm(track.shapes.map((shape) => distance(tipOf(shape), [goal.x_m, goal.y_m]))))),
  });
  if (motion.tracks.some(({ clearances_m }) => clearances_m.length > 0)) {
    charts.push({
      title: 'Clearance', unit: 'cm', series: motion.tracks.map((track) => series(track, cm(track.clearances_m))),
    });
  }
  return charts.filter((chart) => chart.series.length > 0);
}

/** Numbers for an axis: a round step, three or four of them. */
export function ticks(low: number, high: number): number[] {
  const raw = Math.max(1e-9, high - low) / 3;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw)!;
  const result: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) result.push(k * step);
  return result;
}

/** All charts of a motion. `at` moves their cursors. */
export class Plots {
  readonly element = h('div', { class: 'plots' });
  private cursors: { line: SVGElement; x: (time_s: number) => number; values: (time_s: number) => void }[] = [];

  constructor(private readonly seek: (time_s: number) => void) {}

  show(charts: Chart[], rate_hz: number, shown: Set<TrackKey>): void {
    this.cursors = [];
    this.element.replaceChildren(...charts.map((chart) =>
      this.chart({ ...chart, series: chart.series.filter(({ swatch }) => swatch === 'set' || shown.has(swatch as TrackKey)) }, rate_hz)));
  }

  at(time_s: number): void {
    for (const { line, x, values } of this.cursors) {
      line.setAttribute('x1', x(time_s).toFixed(1));
      line.setAttribute('x2', x(time_s).toFixed(1));
      values(time_s);
    }
  }

  private chart({ title, unit, series }: Chart, rate_hz: number): HTMLElement {
    const numbers = series.flatMap(({ values }) => values.filter((value): value is number => value !== null));
    const low = Math.min(0, ...numbers);
    const high = Math.max(low + (unit === 'cm' ? 0.1 : 1), ...numbers);
    const last_s = Math.max(1, ...series.map(({ values }) => values.length - 1)) / rate_hz;
    const x = (time_s: number) => kLeft + (Math.min(time_s, last_s) / last_s) * (kWidth - kLeft - 2);
    const y = (value: number) => kFoot + (1 - (value - low) / (high - low)) * (kHeight - 2 * kFoot);
    const path = (values: (number | null)[]) => {
      let pen = 'M';
      return values.map((value, k) => {
        if (value === null) {
          pen = 'M';
          return '';
        }
        const point = `${pen}${x(k / rate_hz).toFixed(1)} ${y(value).toFixed(1)}`;
        pen = 'L';
        return point;
      }).join('');
    };
    const line = svg('line', { class: 'cursor', y1: 0, y2: kHeight, x1: kLeft, x2: kLeft });
    const picture = svg('svg', { viewBox: `0 0 ${kWidth} ${kHeight}`, role: 'img', 'aria-label': `${title} in ${unit}, over ${last_s.toFixed(1)} s` },
      ...ticks(low, high).flatMap((value) => [
        svg('line', { class: 'tick', x1: kLeft, x2: kWidth, y1: y(value), y2: y(value) }),
        svg('text', { x: kLeft - 5, y: y(value) + 3.5, 'text-anchor': 'end' }, String(Number(value.toPrecision(6)))),
      ]),
      ...series.map(({ swatch, values }) => svg('path', { class: `line ${swatch}`, d: path(values) })),
      line);
    const move = (event: PointerEvent) => {
      if (event.buttons === 0) return;
      const box = picture.getBoundingClientRect();
      const at = ((event.clientX - box.left) / box.width) * kWidth;
      this.seek(Math.max(0, Math.min(1, (at - kLeft) / (kWidth - kLeft - 2))) * last_s);
    };
    picture.addEventListener('pointerdown', move);
    picture.addEventListener('pointermove', move);
    const outputs = series.map(() => h('b'));
    this.cursors.push({
      line, x,
      values: (time_s) => series.forEach(({ values }, i) => {
        const value = values[Math.min(values.length - 1, Math.round(time_s * rate_hz))];
        outputs[i].textContent = value == null ? '–' : value.toFixed(unit === 'cm' ? 2 : 1);
      }),
    });
    return h('figure', {},
      h('figcaption', {}, `${title}, ${unit}`,
        h('span', {}, ...series.map(({ swatch, name }, i) => h('span', { title: name }, h('i', { class: `swatch ${swatch}` }), outputs[i])))),
      picture as unknown as HTMLElement);
  }
}
