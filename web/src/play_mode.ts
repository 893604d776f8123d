import { post, type Run, type TrackKey } from './api';
import type { App, Mode } from './app';
import { button, h } from './dom';
import { tracksPanel, trackNames } from './panels';
import type { Figure, Scene } from './picture';
import { distance, frameAt, tipOf } from './shape';

/** The plan by every model, over one another, with a slider for the time. */
export class PlayMode implements Mode {
  private run: Run | null = null;
  private shown = new Set<TrackKey>(['simple', 'network', 'virtual_arm']);
  private time_s = 0;
  private playing = false;
  private last_ms = 0;
  private request = 0;
  private slider = h('input', { type: 'range', min: 0, step: 'any', 'aria-label': 'Time in seconds' });
  private clock = h('output');
  private press = button('Play', () => this.toggle(), { class: 'main' });
  private readout = h('div', { id: 'readout' });

  constructor(private readonly app: App) {
    this.slider.addEventListener('input', () => {
      this.playing = false;
      this.seek(this.slider.valueAsNumber);
    });
  }

  enter(panel: HTMLElement): void {
    const { app } = this;
    this.run = null;
    if (!app.planner.plan || !app.planner.isCurrent) {
      panel.append(h('section', {}, h('p', {}, 'There is no certified plan to play yet.'),
        button('Back to Plan', () => app.enter('plan'), { class: 'main' })));
      return;
    }
    panel.append(h('section', {}, h('p', { class: 'hint', 'aria-live': 'polite' }, 'Moving the models …')));
    void app.attempt(() => post('run', { tab: app.tab, request: ++this.request }));
  }

  leave(): void {
    this.playing = false;
  }

  onRun(run: Run): void {
    if (run.request !== this.request) return;
    this.run = run;
    this.slider.max = String(this.duration_s);
    this.time_s = 0;
    const tracks = tracksPanel(run, this.shown, (key, on) => {
      if (on) this.shown.add(key);
      else this.shown.delete(key);
      this.app.refresh();
    });
    document.getElementById('panel')!.replaceChildren(
      h('section', {}, h('h2', {}, 'Time'), h('div', { class: 'play' }, this.press, this.slider, this.clock)),
      h('section', {}, h('h2', {}, 'The same set points, moved by'), tracks),
      h('section', {}, h('h2', {}, 'Now'), this.readout),
    );
    this.toggle();
  }

  private get duration_s(): number {
    return this.run ? (this.run.setpoints_kpa.length - 1) / this.run.frame_rate_hz : 0;
  }

  private toggle(): void {
    this.playing = !this.playing;
    if (this.playing && this.time_s >= this.duration_s) this.time_s = 0;
    this.last_ms = performance.now();
    if (this.playing) requestAnimationFrame((now) => this.step(now));
    this.app.refresh();
  }

  private step(now_ms: number): void {
    if (!this.playing) return;
    const next_s = this.time_s + Math.max(0, now_ms - this.last_ms) / 1000;
    this.last_ms = now_ms;
    if (next_s >= this.duration_s) this.playing = false;
    else requestAnimationFrame((now) => this.step(now));
    this.seek(next_s);
  }

  private seek(time_s: number): void {
    this.time_s = Math.min(time_s, this.duration_s);
    this.app.refresh();
  }

  refresh(): void {
    const { run } = this;
    if (!run) return;
    this.press.textContent = this.playing ? 'Pause' : 'Play';
    this.slider.value = String(this.time_s);
    this.slider.setAttribute('aria-valuetext', `${this.time_s.toFixed(1)} seconds`);
    this.clock.textContent = `${this.time_s.toFixed(1)} s`;
    const arm = run.tracks.find(({ key }) => key === 'virtual_arm') ?? run.tracks[0];
    const at = <T>(frames: T[]): T => frameAt(frames, run.frame_rate_hz, this.time_s);
    const tip = tipOf(at(arm.shapes));
    const setpoints = at(run.setpoints_kpa);
    const pressures = at(arm.pressures_kpa);
    const { unit } = this.app;
    this.readout.replaceChildren(
      h('table', {},
        h('thead', {}, h('tr', {}, ...['Segment', `Set, ${unit}`, `Has, ${unit}`].map((text) => h('th', { scope: 'col' }, text)))),
        h('tbody', {}, ...setpoints.map((kpa, i) =>
          h('tr', {}, h('th', { scope: 'row' }, String(i)), h('td', {}, kpa.toFixed(1)), h('td', {}, pressures[i].toFixed(1)))))),
      ...run.tracks.filter((track) => track !== arm).map((track) =>
        h('p', {}, `${trackNames[track.key]}: its tip is ${(100 * distance(tip, tipOf(at(track.shapes)))).toFixed(2)} cm from the ${trackNames[arm.key].toLowerCase()}’s`)),
    );
  }

  scene(): Partial<Scene> {
    const { run } = this;
    if (!run) return {};
    const figures = run.tracks
      .filter(({ key }) => this.shown.has(key))
      .map(({ key, shapes, pressures_kpa }): Figure => ({
        shape: frameAt(shapes, run.frame_rate_hz, this.time_s),
        pressures_kpa: frameAt(pressures_kpa, run.frame_rate_hz, this.time_s),
        colour: key,
        outlined: key !== 'virtual_arm' && run.tracks.some((track) => track.key === 'virtual_arm' && this.shown.has(track.key)),
        trail: shapes.slice(0, Math.round(this.time_s * run.frame_rate_hz) + 1).map(tipOf),
      }));
    return { figures: figures.reverse(), showReach: false };
  }

  legend(): [string, string][] {
    return [['pressure', 'Pressurised side'], ['goal', 'Goal']];
  }
}
