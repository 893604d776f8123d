import { type Experiment, get, type Measured, post, type TrialRun } from './api';
import type { App } from './app';
import { button, choice, field, h } from './dom';
import type { Mode } from './mode';
import type { Scene } from './picture';
import { coverageMaps, experimentTable, horizonChart, playOf } from './results';

/** What was made before: the last experiment's runs to play, and the model's errors on recordings. */
export class ResultsMode implements Mode {
  private experiment: Experiment | null = null;
  private open: number | null = null; // the row whose runs are shown
  private runs: TrialRun[] | null = null;
  private table = h('div');
  private onRecording = h('section');
  private recording = '';
  private request = 0;
  private measuring = false;
  private bar = h('progress', { 'aria-label': 'Share that is measured', max: 1, value: 0 });
  private press = button('Measure', () => this.measure(), { class: 'main' });
  private stop = button('Stop', () => this.end());
  private measured = h('div', { id: 'measured', 'aria-live': 'polite' });

  constructor(private readonly app: App) {}

  enter(panel: HTMLElement): void {
    panel.append(h('section', {}, h('h2', {}, 'The last experiment'), this.table), this.onRecording);
    this.onRecording.replaceChildren();
    this.experiment = this.runs = this.open = null;
    this.table.replaceChildren(h('p', { class: 'hint' }, 'Looking …'));
    this.measured.replaceChildren();
    void this.app.attempt(async () => {
      await this.app.readProject(); // runs on an arm have been recorded since the page was opened
      this.showRecordings();
      this.experiment = await get<Experiment>('experiment');
      this.show();
    });
  }

  private showRecordings(): void {
    const { recordings } = this.app.project;
    if (!recordings.includes(this.recording)) this.recording = recordings[0] ?? '';
    this.onRecording.replaceChildren(h('h2', {}, 'The model on a recording'), ...(recordings.length === 0
      ? [h('p', { class: 'hint' }, 'There is no recording in the project folder: limber collect makes one.')]
      : [field('Recording', choice(recordings, this.recording, (name) => (this.recording = name))),
          h('div', { class: 'row' }, this.press, this.stop, this.bar), this.measured]));
  }

  leave(): void {
    if (this.measuring) this.end();
    this.app.planner.giveUp();
  }

  private show(): void {
    const { experiment } = this;
    if (!experiment) return;
    if (experiment.folder === '') {
      this.table.replaceChildren(h('p', { class: 'hint' }, 'There is none in the project folder: limber experiment makes one.'));
      return;
    }
    const focused = this.table.contains(document.activeElement);
    this.table.replaceChildren(h('p', {}, experiment.folder),
      experimentTable(experiment, this.open, this.runs, (row) => this.toggle(row), (run) => this.play(run)));
    if (focused && this.open !== null) this.table.querySelector<HTMLElement>('[aria-expanded=true]')?.focus();
  }

  private toggle(row: number): void {
    this.open = this.open === row ? null : row;
    this.runs = null;
    this.show();
    if (this.open === null) {
      this.table.querySelectorAll<HTMLElement>('[aria-expanded]')[row]?.focus();
      return;
    }
    void this.app.attempt(async () => {
      const { runs } = await post<{ runs: TrialRun[] }>('experiment/runs', { folder: this.experiment?.folder, row });
      if (this.open !== row) return;
      this.runs = runs;
      this.show();
    });
  }

  /** As its row was executed, as far as Play can. */
  private play({ plan }: TrialRun): void {
    const { app, experiment, open } = this;
    if (plan === null || experiment === null || open === null || !app.mayLose('Open the scene of this run?')) return;
    const { options, leftOut } = playOf(experiment.rows[open]);
    this.measuring = false; // the tab does one thing at a time
    this.refresh();
    app.opening.ask(plan, () => {
      Object.assign(app.modes.play.options, options);
      app.enter('play');
      if (leftOut) app.say(`Played without what the experiment had: ${leftOut}`);
    });
  }

  private measure(): void {
    const { app } = this;
    app.planner.giveUp();
    this.measuring = true;
    this.bar.value = 0;
    this.measured.replaceChildren();
    this.refresh();
    void app.attempt(async () => {
      try {
        await post('measure', { tab: app.tab, request: ++this.request, arm: app.armName, model: app.model, recording: this.recording });
      } catch (error) {
        this.onFault(this.request, (error as Error).message);
      }
    });
  }
  private end(): void {
    this.measuring = false;
    ++this.request;
    this.refresh();
    this.app.endWork();
  }

  onMeasuring(request: number, share: number): void {
    if (request === this.request) this.bar.value = share;
  }
  onMeasured(measured: Measured): void {
    if (measured.request !== this.request) return;
    this.measuring = false;
    const { frames, frames_used, frame_rate_hz, learnt_from_it, horizons, coverage } = measured;
    const span = (count: number) => `${(count / frame_rate_hz / 60).toFixed(1)} min`;
    this.measured.replaceChildren(
      ...(learnt_from_it ? [h('p', { class: 'warning' }, 'The model learnt from this recording: its errors there say nothing.')] : []),
      h('p', {}, frames_used < frames ? `Its first ${span(frames_used)} of ${span(frames)}` : `All of its ${span(frames)}`, '. Mean tip error in cm, over the time since the last correction:'),
      horizonChart(horizons, frame_rate_hz),
      h('p', {}, 'Pressures that it covers, by pairs of segments'),
      coverageMaps(coverage, this.app.arm));
    this.refresh();
  }
  onFault(request: number, message: string): void {
    if (!this.measuring || request !== this.request) return;
    this.measuring = false;
    this.measured.replaceChildren(h('p', { class: 'warning' }, message));
    this.refresh();
  }

  refresh(): void {
    this.press.disabled = this.measuring;
    this.stop.disabled = !this.measuring;
    this.bar.hidden = !this.measuring;
  }

  scene(): Partial<Scene> {
    return { figures: [{ shape: this.app.arm.rest, colour: 'plate' }] };
  }

  legend(): [string, string][] {
    return [['goal', 'Goal'], ['reach', 'Reached by the simple model, at rest']];
  }
}
