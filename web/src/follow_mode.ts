import { type Followed, post } from './api';
import type { App } from './app';
import { button, choice, field, h } from './dom';
import type { Point } from './environment';
import { exportRow, save } from './export';
import type { Mode } from './mode';
import { durationOf, figuresAt, mainOf } from './motion';
import { csvOf, figureOf, pathOf, timed } from './path';
import type { Scene } from './picture';
import { Player } from './player';
import { chartsOf, Plots } from './plots';

const kSeconds = ['5', '10', '20', '30', '60'];
const kNear_m = 0.002; // a hand's next point

/** A path drawn by hand, and the virtual arm whose tip follows it. */
export class FollowMode implements Mode {
  private drawn: Point[] = []; // while the hand draws
  private path: Point[] = [];
  private seconds = 20;
  private run: Followed | null = null;
  private request = 0;
  private readonly outcome = h('div');
  private readonly plots = new Plots((time_s) => this.player.seek(time_s));
  private readonly player = new Player(() => (this.run ? durationOf(this.run) : 0), (time_s) => {
    if (this.run) this.plots.at(time_s);
    this.app.stage.draw();
  });

  constructor(private readonly app: App) {}

  enter(panel: HTMLElement): void {
    const set = (points: Point[]) => {
      this.path = points;
      this.ask();
    };
    const ready = (kind: 'circle' | 'eight') => () => {
      const reach_m = this.app.arm.length_m;
      set(figureOf(kind, [0.55 * reach_m, 0.5 * reach_m], 0.1 * reach_m));
    };
    panel.append(
      h('section', {}, h('h2', {}, 'A path for the tip'),
        h('p', { class: 'hint' }, 'Draw it on the picture. The virtual arm follows it, closed loop.'),
        h('div', { class: 'row' }, button('Circle', ready('circle')), button('Eight', ready('eight')),
          button('Backwards', () => set([...this.path].reverse())),
          button('CSV', () => save('path.csv', new Blob([csvOf(this.timed())], { type: 'text/csv' })),
            { title: 'Save the path for limber execute --track' })),
        h('div', { class: 'fields' }, field('Takes', choice(kSeconds, String(this.seconds), (text) => {
          this.seconds = Number(text);
          this.ask();
        }), 's'))),
      h('section', {}, h('h2', {}, 'Time'), this.player.element),
      h('section', {}, this.outcome),
      h('section', {}, h('h2', {}, 'Over time'), this.plots.element),
      h('section', {}, h('h2', {}, 'Save the picture'), exportRow(this.app)));
    this.ask();
  }
  leave(): void {
    this.player.seek(0);
    this.run = null;
    ++this.request; // what is still on its way is of no use
    this.app.endWork();
  }

  down(at: Point): boolean {
    this.drawn = [at];
    return true;
  }
  drag(at: Point): void {
    const last = this.drawn[this.drawn.length - 1];
    if (Math.hypot(at[0] - last[0], at[1] - last[1]) < kNear_m) return;
    this.drawn.push(at);
    this.app.stage.draw();
  }
  up(isCut: boolean): void {
    const { drawn, isStroke } = this;
    this.drawn = [];
    this.app.stage.draw();
    if (!isStroke || isCut) return; // the path before stays, and its run
    this.path = pathOf(drawn);
    this.ask();
  }
  private get isStroke(): boolean {
    return this.drawn.length > 2;
  }

  private timed(): number[] {
    return this.path.length > 1 ? timed(this.path, this.seconds) : [];
  }
  private say(text: string, isBad = false): void {
    this.outcome.replaceChildren(h('p', { class: isBad ? 'warning' : 'hint', 'aria-live': 'polite' }, text));
  }
  private ask(): void {
    this.run = null;
    this.player.seek(0);
    this.plots.show([], 1, new Set());
    if (this.path.length < 2) return this.say('There is no path yet.');
    this.say('The arm follows …');
    const { tab, armName: arm, model, environment } = this.app;
    const request = ++this.request;
    void this.app.attempt(() => post<void>('follow', { tab, request, arm, model, environment, path: this.timed() })
      .catch((error: Error) => this.onFault(request, error.message)));
  }

  onFollowed(run: Followed): void {
    if (run.request !== this.request) return;
    this.run = run;
    this.say(mainOf(run).outcome);
    this.plots.show(chartsOf(run, mainOf(run), run.wanted_m, this.app.unit), run.frame_rate_hz, this.shown);
    this.player.seek(0);
    this.player.toggle();
  }
  onFault(request: number, message: string): void {
    if (request === this.request) this.say(message, true);
  }
  private get shown() {
    return new Set(this.run?.tracks.map(({ key }) => key));
  }

  refresh(): void {}

  scene(): Partial<Scene> {
    const { run, app } = this;
    const path = this.isStroke ? this.drawn : this.path;
    const atRest = { shape: app.arm.rest, colour: 'virtual_arm' as const };
    return { path, hidesGoal: true, figures: run ? figuresAt(run, this.shown, this.player.time_s) : [atRest] };
  }

  legend(): [string, string][] {
    return [['goal', 'The path wanted'], ['virtual_arm', 'Virtual arm'], ['pressure', 'Pressurised side']];
  }
}
