// Charts over time. The slider moves their cursors and a click moves the slider; hovering shows a moment's numbers, a
// drag zooms all of them, and a double click shows everything again.

import uPlot from 'uplot';
import type { Goal, Motion, Track, TrackKey } from './api';
import { h } from './dom';
import type { Point } from './environment';
import { trackNames } from './names';
import { distance, tipOf } from './shape';

type Series = { name: string; swatch: string; values: (number | null)[] };
export type Chart = { title: string; unit: string; series: Series[] };

const kWidth = 308; // until it is laid out
const kHeight = 84;
const kLeft = 34; // of the axis' numbers
const kTogether = 'time'; // cursors and zoom

/** What there is to see of a motion; `main` is the track that is the most real, `wanted` a goal or a tip for each frame. */
export function chartsOf(motion: Motion, main: Track, wanted: Goal | Point[], unit: string): Chart[] {
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
    title: Array.isArray(wanted) ? 'Tip from the path' : 'Tip from the goal’s centre',
    unit: 'cm',
    series: motion.tracks.map((track) => series(track, cm(track.shapes.map((shape, k) =>
      distance(tipOf(shape), Array.isArray(wanted) ? wanted[Math.min(k, wanted.length - 1)] : [wanted.x_m, wanted.y_m]))))),
  });
  if (motion.tracks.some(({ clearances_m }) => clearances_m.length > 0)) {
    charts.push({
      title: 'Clearance', unit: 'cm', series: motion.tracks.map((track) => series(track, cm(track.clearances_m))),
    });
  }
  return charts.filter((chart) => chart.series.length > 0);
}

const colour = (name: string) => () =>
  getComputedStyle(document.documentElement).getPropertyValue(name === 'set' ? '--quiet' : `--${name}`);

/** All charts of a motion. `at` moves their cursors. */
export class Plots {
  readonly element = h('div', { class: 'plots' });
  private charts: { plot: uPlot; show: () => void }[] = [];
  private time_s = 0;

  constructor(private readonly seek: (time_s: number) => void) {
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.charts.forEach(({ plot }) => plot.redraw(false)));
    new ResizeObserver(() => {
      const width = this.element.clientWidth;
      if (width > 0) this.charts.forEach(({ plot }) => plot.setSize({ width, height: kHeight }));
    }).observe(this.element);
  }

  show(charts: Chart[], rate_hz: number, shown: Set<TrackKey>): void {
    this.charts.forEach(({ plot }) => plot.destroy());
    this.charts = [];
    this.element.replaceChildren(...charts.map((chart) =>
      this.chart({ ...chart, series: chart.series.filter(({ swatch }) => swatch === 'set' || shown.has(swatch as TrackKey)) }, rate_hz)));
  }

  at(time_s: number): void {
    this.time_s = time_s;
    for (const { plot, show } of this.charts.filter(({ plot: { status } }) => status === 1)) { // it has been laid out
      plot.setCursor({ left: plot.valToPos(time_s, 'x'), top: 0 }, false);
      show();
    }
  }

  private chart({ title, unit, series }: Chart, rate_hz: number): HTMLElement {
    const frames = Math.max(2, ...series.map(({ values }) => values.length));
    const time_s = Array.from({ length: frames }, (_, k) => k / rate_hz);
    const padded = series.map(({ values }) => [...values, ...Array<null>(frames - values.length).fill(null)]);
    const outputs = series.map(() => h('b'));
    const at = h('div', { role: 'img', 'aria-label': `${title} in ${unit}, over ${time_s[frames - 1].toFixed(1)} s` });
    const grid = { show: true, stroke: colour('grid'), width: 1 };
    const plot: uPlot = new uPlot({
      width: this.element.clientWidth || kWidth,
      height: kHeight,
      padding: [6, 2, 6, 0],
      legend: { show: false },
      cursor: { y: false, drag: { x: true, y: false }, sync: { key: kTogether }, points: { size: 5 } },
      scales: {
        x: { time: false },
        y: { range: (_, low, high) => [Math.min(0, low), Math.max(Math.min(0, low) + (unit === 'cm' ? 0.1 : 1), high)] },
      },
      axes: [{ show: false }, { size: kLeft, gap: 3, space: 22, font: '10px system-ui, sans-serif', stroke: colour('quiet'), grid, ticks: { show: false } }],
      series: [{}, ...series.map(({ swatch }): uPlot.Series => ({
        stroke: colour(swatch), width: 1.6, points: { show: false }, ...(swatch === 'set' ? { dash: [3, 2] } : {}),
      }))],
      hooks: { ready: [() => this.at(this.time_s)], setCursor: [() => show()] },
    }, [time_s, ...padded] as uPlot.AlignedData, at);
    const show = () => series.forEach(({ values }, i) => {
      const k = Math.min(values.length - 1, plot.cursor.idx ?? Math.round(this.time_s * rate_hz));
      outputs[i].textContent = values[k] == null ? '–' : values[k]!.toFixed(unit === 'cm' ? 2 : 1);
    });
    plot.over.addEventListener('click', (event) => this.seek(Math.max(0, plot.posToVal(event.offsetX, 'x'))));
    plot.over.addEventListener('mouseleave', () => this.at(this.time_s));
    this.charts.push({ plot, show });
    return h('figure', {},
      h('figcaption', {}, `${title}, ${unit}`,
        h('span', {}, ...series.map(({ swatch, name }, i) => h('span', {}, h('i', { class: `swatch ${swatch}` }), `${name} `, outputs[i])))),
      at);
  }
}
