import { type ArmFrame, type Environment, type Motion, type Plan, post, type Run, type TrackKey } from './api';
import type { App } from './app';
import { ArmPanel } from './arm_panel';
import { button, changeText, checkbox, h } from './dom';
import type { Point } from './environment';
import { exportRow } from './export';
import type { Mode } from './mode';
import { durationOf, environmentAt, figuresAt, mainOf, possible, type RunOptions } from './motion';
import { tracksPanel } from './panels';
import type { Figure, Scene } from './picture';
import { Player } from './player';
import { chartsOf, Plots } from './plots';
import { lengthen } from './shape';

/** The plan by every model and by the arm, over one another, with a slider for the time. */
export class PlayMode implements Mode {
  private run: Motion | null = null;
  private shown = new Set<TrackKey>(['simple', 'network', 'virtual_arm', 'arm']);
  private request = 0;
  readonly options: RunOptions = { replan: false, obstacle: false }; // as they were ticked
  private trail: Point[] = []; // of the arm's tip, while it moves
  private seen: ArmFrame | null = null; // the last one of the trail
  private armRun: { plan: Plan | null; environment: Environment; motion: Motion | null } | null = null; // the last one
  private boxes = h('div', { class: 'checks' });
  private player: Player = new Player(() => (this.run ? durationOf(this.run) : 0), () => this.app.refresh(), () => this.toggle());
  private stop = button('Stop', () => void this.app.attempt(() => this.app.armLink.stop().then(() => {})));
  private tracks = h('div');
  private plots = new Plots((time_s) => {
    if (!this.app.armLink.live) this.player.seek(time_s);
  });
  private armPanel: ArmPanel;

  constructor(private readonly app: App) {
    this.armPanel = new ArmPanel(app);
  }

  enter(panel: HTMLElement): void {
    const { app } = this;
    this.run = null;
    const arm = this.armPanel.isThere && h('section', {}, h('h2', {}, 'The arm'), this.armPanel.element, h('div', { class: 'row' }, this.stop)) || '';
    if (!app.planner.plan || !app.planner.isCurrent) {
      panel.append(h('section', {}, h('p', {}, 'There is no certified plan to play yet.'),
        button('Back to Plan', () => app.enter('plan'), { class: 'main' })),
        app.armLink.isMine && arm || ''); // it may be stopped and disarmed without one
      return;
    }
    const choose = (label: string, key: 'replan' | 'obstacle') =>
      checkbox(label, this.options[key], (on) => {
        this.options[key] = on;
        this.armRun = null; // it was run otherwise
        this.ask();
      });
    this.boxes.replaceChildren(...(app.model === '' ? [] : [choose('Closed loop', 'replan')]),
      choose('Drop an obstacle into the way', 'obstacle'));
    panel.append(
      h('section', {}, h('h2', {}, 'Time'), this.player.element, this.boxes),
      arm,
      h('section', {}, h('h2', {}, 'The same plan, moved by'), this.tracks),
      h('section', {}, h('h2', {}, 'Over time'), this.plots.element),
      h('section', {}, h('h2', {}, 'Save'), exportRow(app, () => this.run)));
    this.ask();
  }

  leave(): void {
    this.player.halt(0);
    ++this.request; // what is still on its way would play unseen
    if (!this.run) this.app.endWork();
  }

  private ask(): void {
    this.run = null;
    this.player.halt(0);
    this.tracks.replaceChildren(h('p', { class: 'hint', 'aria-live': 'polite' }, 'Moving the models …'));
    this.plots.show([], 1, this.shown);
    const { app } = this;
    app.refresh();
    const request = ++this.request;
    void app.attempt(() => post<void>('run', { tab: app.tab, request, plan: app.planner.number, ...possible(this.options, app.model) })
      .catch((error: Error) => this.onFault(request, error.message)));
  }

  onRun(run: Run): void {
    if (run.request !== this.request) return;
    this.show(run);
    if (this.options.obstacle && !run.appeared) this.app.say('No obstacle fits into the way: the motion is too short');
    if (!this.armPanel.isChosen) this.toggle();
  }

  onFault(request: number, message: string): void {
    if (request === this.request) this.tracks.replaceChildren(h('p', { class: 'warning' }, message));
  }

  /** The arm's own motion, once it is over: shown with the models', now or when they are there. */
  onArmRun(motion: Motion): void {
    const { app, armRun } = this;
    if (!armRun || !app.armLink.ownRun) return;
    this.trail = [];
    armRun.motion = motion;
    if (armRun.plan !== app.planner.plan) return app.say('The arm’s run was of the plan before: it is recorded');
    if (!this.run) return;
    this.show(this.run);
    this.player.seek(durationOf(this.run));
  }
  /** Beside the models' motions of the same plan. */
  private withArm(run: Motion): Motion {
    const { motion, plan } = this.armRun ?? {};
    if (!motion || plan !== this.app.planner.plan) return run;
    const models = run.tracks.filter(({ key }) => key !== 'arm' && key !== 'virtual_arm');
    return { ...motion, tracks: [...models, ...motion.tracks] };
  }

  private show(motion: Motion): void {
    const run = this.withArm(motion);
    this.run = run;
    this.tracks.replaceChildren(tracksPanel(run, this.shown, () => {
      this.plot();
      this.app.refresh();
    }));
    this.plot();
    this.player.seek(0);
  }
  private plot(): void {
    const { run, app } = this;
    if (run) this.plots.show(chartsOf(run, mainOf(run), app.environment.goal, app.unit), run.frame_rate_hz, this.shown);
  }

  /** Play and Pause: of the arm, if it is armed here; else of what is shown. */
  private toggle(): void {
    const { app } = this;
    if (this.armPanel.isChosen) {
      const { armLink } = app;
      if (armLink.runs) return void app.attempt(() => armLink.pause(!armLink.paused));
      this.trail = [];
      this.armRun = { plan: app.planner.plan, environment: app.environment, motion: null };
      this.player.seek(0);
      return void app.attempt(() => armLink.run({ ...possible(this.options, app.model), limit_scale: this.armPanel.limitScale, plan: app.planner.number }));
    }
    if (this.run) this.player.toggle();
  }

  refresh(): void {
    const { run, player } = this;
    const { armLink } = this.app;
    const { live } = armLink;
    const isLive = armLink.runs && armLink.ownRun;
    this.armPanel.refresh(this.app.planner.plan);
    this.stop.disabled = !armLink.runs || !armLink.isMine;
    if (live) {
      player.halt(live.time_s);
      if (live.shape && live !== this.seen) lengthen(this.trail, live.shape);
      this.seen = live;
    }
    player.slider.disabled = isLive;
    for (const box of this.boxes.querySelectorAll('input')) box.disabled = isLive; // they are as it began
    player.press.disabled = isLive && !armLink.isMine;
    changeText(player.press, isLive
      ? (armLink.paused ? 'Go on' : 'Pause')
      : player.playing ? 'Pause' : this.armPanel.isChosen ? 'Play on the arm' : 'Play');
    if (run) this.plots.at(player.time_s);
  }

  scene(): Partial<Scene> {
    const { run, player: { time_s } } = this;
    const { armLink: { live }, environment, planner, view } = this.app;
    const showTree = view.tree ? planner.tree : null;
    if (!live) {
      return run ? { environment: environmentAt(environment, run, time_s), figures: figuresAt(run, this.shown, time_s), showReach: false, showTree } : {};
    }
    const around = this.armRun?.environment ?? environment;
    const models = new Set([...this.shown].filter((key) => key !== 'arm' && key !== 'virtual_arm'));
    const now: Figure[] = live.shape ? [{ shape: live.shape, pressures_kpa: live.pressure_kpa, colour: 'arm', trail: this.trail }] : [];
    return {
      environment: { ...around, obstacles: [...around.obstacles, ...(live.obstacle ? [live.obstacle] : [])] },
      figures: [...now, ...(run && around === environment ? figuresAt(run, models, time_s, true) : [])],
      showReach: false,
    };
  }

  legend(): [string, string][] {
    return [['pressure', 'Pressurised side'], ['goal', 'Goal']];
  }
}
