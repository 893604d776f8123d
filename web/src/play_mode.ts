import { type Motion, post, type Run, type TrackKey } from './api';
import type { App, Mode } from './app';
import { ArmPanel } from './arm_panel';
import { button, checkbox, h } from './dom';
import type { Point } from './environment';
import { exportRow } from './export';
import { durationOf, environmentAt, figuresAt, mainOf } from './motion';
import { tracksPanel } from './panels';
import type { Figure, Scene } from './picture';
import { chartsOf, Plots } from './plots';
import { tipOf } from './shape';

/** The plan by every model and by the arm, over one another, with a slider for the time. */
export class PlayMode implements Mode {
  private run: Motion | null = null;
  private shown = new Set<TrackKey>(['simple', 'network', 'virtual_arm', 'arm']);
  private time_s = 0;
  private playing = false;
  private last_ms = 0;
  private request = 0;
  private options = { replan: false, obstacle: false };
  private trail: Point[] = []; // of the arm's tip, while it moves
  private slider = h('input', { type: 'range', min: 0, step: 'any', 'aria-label': 'Time in seconds' });
  private clock = h('output');
  private press = button('Play', () => this.toggle(), { class: 'main' });
  private stop = button('Stop', () => void this.app.attempt(() => this.app.armLink.stop().then(() => {})));
  private tracks = h('div');
  private plots = new Plots((time_s) => {
    this.playing = false;
    if (!this.app.armLink.live) this.seek(time_s);
  });
  private armPanel: ArmPanel;

  constructor(private readonly app: App) {
    this.armPanel = new ArmPanel(app);
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
    const choose = (label: string, key: 'replan' | 'obstacle') =>
      checkbox(label, this.options[key], (on) => {
        this.options[key] = on;
        this.ask();
      });
    panel.append(
      h('section', {}, h('h2', {}, 'Time'), h('div', { class: 'play' }, this.press, this.slider, this.clock),
        h('div', { class: 'checks' }, app.model !== '' && choose('Closed loop', 'replan'),
          choose('Drop an obstacle into the way', 'obstacle'))),
      this.armPanel.isThere && h('section', {}, h('h2', {}, 'The arm'), this.armPanel.element, h('div', { class: 'row' }, this.stop)) || '',
      h('section', {}, h('h2', {}, 'The same plan, moved by'), this.tracks),
      h('section', {}, h('h2', {}, 'Over time'), this.plots.element),
      h('section', {}, h('h2', {}, 'Save'), exportRow(app, () => this.run)));
    this.ask();
  }

  leave(): void {
    this.playing = false;
  }

  private ask(): void {
    this.playing = false;
    this.run = null;
    this.tracks.replaceChildren(h('p', { class: 'hint', 'aria-live': 'polite' }, 'Moving the models …'));
    this.plots.show([], 1, this.shown);
    this.app.refresh();
    void this.app.attempt(() => post('run', { tab: this.app.tab, request: ++this.request, ...this.options }));
  }

  onRun(run: Run): void {
    if (run.request !== this.request) return;
    this.show(run);
    if (!this.armPanel.isChosen) this.toggle();
  }

  /** The arm's own motion, once it is over: beside the models' of the same plan. */
  onArmRun(motion: Motion): void {
    if (!this.run || !this.app.armLink.ownRun) return;
    const models = this.run.tracks.filter(({ key }) => key !== 'arm' && key !== 'virtual_arm');
    this.trail = [];
    this.show({ ...motion, tracks: [...models, ...motion.tracks] });
    this.seek(this.duration_s);
  }

  private show(run: Motion): void {
    this.run = run;
    this.slider.max = String(this.duration_s);
    this.time_s = 0;
    this.tracks.replaceChildren(tracksPanel(run, this.shown, (key, on) => {
      if (on) this.shown.add(key);
      else this.shown.delete(key);
      this.plot();
      this.app.refresh();
    }));
    this.plot();
    this.app.refresh();
  }
  private plot(): void {
    const { run, app } = this;
    if (run) this.plots.show(chartsOf(run, mainOf(run), app.environment.goal, app.unit), run.frame_rate_hz, this.shown);
  }

  private get duration_s(): number {
    return this.run ? durationOf(this.run) : 0;
  }

  /** Play and Pause: of the arm, if it is armed here; else of what is shown. */
  private toggle(): void {
    const { app } = this;
    if (this.armPanel.isChosen) {
      const { armLink } = app;
      if (armLink.runs) return void app.attempt(() => armLink.pause(!armLink.paused));
      this.trail = [];
      this.playing = false;
      this.seek(0);
      return void app.attempt(() => armLink.run({ ...this.options, limit_scale: this.armPanel.limitScale }));
    }
    if (!this.run) return;
    this.playing = !this.playing;
    if (this.playing && this.time_s >= this.duration_s) this.time_s = 0;
    this.last_ms = performance.now();
    if (this.playing) requestAnimationFrame((now) => this.step(now));
    app.refresh();
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
    const { armLink } = this.app;
    const { live } = armLink;
    const isLive = armLink.runs && armLink.ownRun;
    this.armPanel.refresh(this.app.planner.plan);
    this.stop.disabled = !armLink.runs || !armLink.isMine;
    this.slider.disabled = isLive;
    this.press.disabled = isLive && !armLink.isMine;
    this.press.textContent = isLive
      ? (armLink.paused ? 'Go on' : 'Pause')
      : this.playing ? 'Pause' : this.armPanel.isChosen ? 'Play on the arm' : 'Play';
    if (live) {
      this.playing = false;
      this.time_s = live.time_s;
      this.trail.push(tipOf(live.shape));
    }
    this.slider.value = String(this.time_s);
    this.slider.setAttribute('aria-valuetext', `${this.time_s.toFixed(1)} seconds`);
    this.clock.textContent = `${this.time_s.toFixed(1)} s`;
    if (run) this.plots.at(this.time_s);
  }

  scene(): Partial<Scene> {
    const { run, time_s } = this;
    const { armLink: { live }, environment } = this.app;
    if (!live) {
      return run ? { environment: environmentAt(environment, run, time_s), figures: figuresAt(run, this.shown, time_s), showReach: false } : {};
    }
    const models = new Set([...this.shown].filter((key) => key !== 'arm' && key !== 'virtual_arm'));
    const now: Figure = { shape: live.shape, pressures_kpa: live.pressure_kpa, colour: 'arm', trail: this.trail };
    return {
      environment: { ...environment, obstacles: [...environment.obstacles, ...(live.obstacle ? [live.obstacle] : [])] },
      figures: [now, ...(run ? figuresAt(run, models, time_s, true) : [])],
      showReach: false,
    };
  }

  legend(): [string, string][] {
    return [['pressure', 'Pressurised side'], ['goal', 'Goal']];
  }
}
