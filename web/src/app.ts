import { type Arm, type Environment, get, listen, post, type Project, type Refusal } from './api';
import { ArmLink } from './arm_link';
import { toWorld } from './camera';
import { byId, changeText, h, refilled, tool } from './dom';
import { DriveMode } from './drive_mode';
import { added, newObstacle, type Point, removed, type Selection, stillSelected } from './environment';
import { handlersOf } from './events';
import { FollowMode } from './follow_mode';
import { History } from './history';
import { onKey, tabAfter } from './keys';
import { Latency } from './latency';
import type { Mode } from './mode';
import { Opening } from './opening';
import type { Scene } from './picture';
import { PlanMode } from './plan_mode';
import { LivePlanner } from './planner';
import { PlayMode } from './play_mode';
import { ResultsMode } from './results_mode';
import { fragmentOf, linkOf } from './scene_link';
import { Stage } from './stage';
import { offerVent, showArmState } from './vent_button';

type ModeName = 'plan' | 'play' | 'follow' | 'drive' | 'results';

/** A drag's own frame waits so long: the plan that it asks for, there after 25 to 60 ms, mostly comes with it. */
const kPlanIsNear_ms = 40;

const kLost = 'The studio does not answer. Is limber studio still running, in fewer than five tabs?';
const kForeign = 'The studio was started again: open the address that it has printed.';

/** Everything that modes share: the project, the document and its history, the search, the stage. */
export class App {
  project!: Project;
  saved: Environment | null = null; // as it was opened or saved last
  isInFile = true; // what was opened; a link's scene is in none
  arm!: Arm;
  armName = '';
  model = '';
  environmentName = '';
  readonly history = new History<Environment>({
    name: 'untitled', obstacles: [], start: 'rest',
    goal: { x_m: 0.4, y_m: 0.2, position_tolerance_m: 0.02 },
  });
  selected: Selection = null;
  tab = '';
  live = true;
  timeLimit_s = 5;
  limitScale = 1; // of the pressures that plans may use
  margin_m: number | null = null; // that plans keep from obstacles; null: what the model's error asks for
  view = { tree: false, tube: false, reach: true };
  readonly planner = new LivePlanner(() => this.tab, (seen = true) => this.refreshSoon(seen));
  readonly opening = new Opening(this);
  readonly armLink = new ArmLink(() => this.tab, () => this.armChanged());
  stage!: Stage;
  readonly modes = {
    plan: new PlanMode(this), play: new PlayMode(this), follow: new FollowMode(this),
    drive: new DriveMode(this), results: new ResultsMode(this),
  };
  private mode: ModeName = 'plan';
  private readonly latency = new Latency(this.planner);
  private readonly models = new Map<string, string>(); // chosen last, by arms
  private choice = 0; // of arm, environment and model: the last one wins
  private due = false; // a refresh
  private late: ReturnType<typeof setTimeout> | undefined; // a drag's frame, if no other comes first

  get environment(): Environment {
    return this.history.now;
  }
  get unit(): string {
    return this.arm.command.unit;
  }
  /** The mode that is shown. */
  get entered(): Mode {
    return this.modes[this.mode];
  }

  /** Whether the environment is another than the file, or the link, that it came from. */
  get isChanged(): boolean {
    return this.environment !== this.saved;
  }
  /** Whether the model plans for no arm alone. */
  get isFamily(): boolean {
    return this.project.families.includes(this.model);
  }

  async readProject(): Promise<void> {
    this.project = await get<Project>('project');
  }
  /** Files come and go beside the page: Plan's lists follow. */
  private async readAgain(): Promise<void> {
    const before = JSON.stringify(this.project);
    await this.readProject();
    if (this.mode === 'plan' && JSON.stringify(this.project) !== before) this.show();
  }

  async start(): Promise<void> {
    await this.readProject();
    offerVent(this); // before all that may fail or take long
    this.stage = new Stage(byId<HTMLCanvasElement>('canvas'), () => this.scene(), {
      down: (at, reach, event) => this.down(at, reach, event),
      drag: (at, event) => this.entered.drag?.(at, event.timeStamp),
      up: (isCut) => this.entered.up?.(isCut),
    });
    this.stage.painted = () => this.painted();
    byId('tools').after(
      tool('−', 'Zoom out', () => this.stage.zoom(0.8)),
      tool('+', 'Zoom in', () => this.stage.zoom(1.25)),
      tool('⤢', 'Show everything', () => this.stage.refit()));
    byId('folder').textContent = `${this.project.folder} · limber ${this.project.version}`;
    await this.attempt(async () => void (await this.openLink(location.hash)));
    if (!this.environmentName) await this.openLink('');
    addEventListener('hashchange', () => void this.attempt(async () => {
      if (await this.openLink(location.hash, true)) this.replan();
    }));
    const tabs = (Object.keys(this.modes) as ModeName[]).map((name) => {
      const tab = byId(`mode-${name}`);
      tab.addEventListener('click', () => this.enter(name));
      return tab;
    });
    for (const [i, tab] of tabs.entries()) {
      tab.addEventListener('keydown', ({ key }) => tabs[tabAfter(tabs.length, i, key) ?? i].focus());
    }
    document.addEventListener('keydown', (event) => onKey(this, event, this.mode === 'plan'));
    addEventListener('beforeunload', (event) => {
      if (this.isChanged) event.preventDefault();
    });
    this.enter('plan');
    addEventListener('focus', () => void this.readAgain().catch(() => {}));
    listen(handlersOf(this), (isRefused) => this.lost(isRefused), (on) => this.armLink.sees(on));
  }

  /** The server has this page for that tab from now on. */
  onTab(id: string): void {
    this.tab = id;
    this.armLink.renews(true);
    if ([kLost, kForeign].includes(byId('notice').textContent!)) this.say('');
    if (this.mode === 'plan' && !this.isFamily) return this.ask();
    this.planner.forget(); // it was another tab's: the studio has it no more
    this.enter(this.mode);
  }
  private lost(isRefused: boolean): void {
    this.tab = '';
    this.armLink.sees(false);
    if (!isRefused) return this.say(kLost);
    this.armLink.renews(false); // a page that can't see the arm has no business with it
    this.readProject().then(
      () => this.say(kLost),
      (error: Refusal) => this.say(error.status === 403 ? kForeign : kLost));
  }

  say(text: string): void {
    changeText(byId('notice'), text);
  }
  /** Runs what may be refused, and says why it was. */
  async attempt(work: () => Promise<void>): Promise<void> {
    try {
      this.say('');
      await work();
    } catch (error) {
      this.say((error as Error).message);
    }
  }

  /** Asks; but not while the arm moves: a dialog lets nobody press VENT. */
  confirms(question: string): boolean {
    if (!this.armLink.runs) return confirm(question);
    this.say('Not while the arm moves');
    return false;
  }
  /** Whether what is not saved may go. */
  mayLose(what: string): boolean {
    return !this.isChanged || this.confirms(`What you changed is not saved. ${what}`);
  }

  /**
   * An arm and an environment for it: both, or where one is refused neither.
   * @param isWanted  asked once they are there
   * @return whether they are open: nothing else was chosen meanwhile
   */
  async open(armName: string, environmentName: string, environment: Environment | null = null, isWanted = () => true): Promise<boolean> {
    const choice = ++this.choice;
    const arm = armName === this.armName ? this.arm : await get<Arm>('arm', { name: armName });
    const shown = environment ?? (await get<Environment>('environment', { name: environmentName, arm: armName }));
    if (choice !== this.choice || !isWanted()) return false;
    this.forget();
    if (arm !== this.arm) {
      const { length_m } = arm;
      this.arm = arm;
      this.armName = armName;
      this.stage.fit([-0.12 * length_m, -0.78 * length_m], [1.12 * length_m, 0.78 * length_m]);
    }
    this.history.reset(shown);
    this.saved = this.environment;
    this.isInFile = environment === null;
    this.environmentName = environmentName;
    this.selected = this.margin_m = null;
    return true;
  }
  /** The model for the same arm and environment. */
  choose(model: string): boolean {
    ++this.choice;
    this.model = model;
    this.models.set(this.armName, model);
    this.margin_m = null;
    return true;
  }
  /** The one that was chosen last for the arm; else the simple one. */
  modelBefore(): string {
    const model = this.models.get(this.armName) ?? '';
    return this.project.models.includes(model) ? model : '';
  }

  /**
   * Of an address. A scene that comes to an open one of the same arm is a step of its history.
   * @param asks  before what is not saved is lost
   * @return whether it was opened
   */
  private async openLink(fragment: string, asks = false): Promise<boolean> {
    const { arm, model, environmentName, environment } = linkOf(fragment, this.project);
    if (environment && arm === this.armName) {
      this.history.set(environment);
      this.environmentName = environmentName;
      this.selected = null;
      this.saved = this.environment;
      this.isInFile = false;
    } else if (asks && !this.mayLose('Open the link?')) {
      this.link(); // the address says again what is open; that makes no hashchange
      return false;
    } else if (!(await this.open(arm, environmentName, environment))) {
      return false;
    }
    return this.choose(model);
  }
  /** The page's address, so that a bookmark opens what is chosen. @param environment  with it */
  link(environment: Environment | null = null): string {
    const { armName: arm, model, environmentName } = this;
    history.replaceState(null, '', fragmentOf({ arm, model, environmentName, environment }));
    return location.href;
  }

  /** After another arm, model or environment was chosen. */
  reopened(): void {
    this.link();
    this.replan();
  }
  private replan(): void {
    this.forget();
    this.enter(this.mode);
    if (this.mode === 'plan') this.ask();
  }

  enter(mode: ModeName): void {
    this.entered.leave();
    const isAnother = mode !== this.mode;
    this.mode = mode;
    for (const name of Object.keys(this.modes)) {
      const tab = byId(`mode-${name}`);
      tab.ariaSelected = String(name === mode);
      tab.tabIndex = name === mode ? 0 : -1; // arrow keys lead to the others
    }
    if (isAnother && byId('panel').contains(document.activeElement)) byId(`mode-${mode}`).focus();
    this.show();
    if (isAnother && mode === 'plan') void this.readAgain().catch(() => {}); // it is lost, and says so
  }
  /** The mode's panel and legend, from the start. */
  show(): void {
    const mode = this.entered;
    const panel = byId('panel');
    refilled(panel, () => {
      panel.replaceChildren();
      mode.enter(panel);
      byId('legend').replaceChildren(...mode.legend().map(([swatch, words]) =>
        h('li', {}, h('i', { class: `swatch ${swatch}` }), words)));
      this.refresh();
    });
  }

  /** Asks for a plan of what is shown. @param again  by other samples */
  ask(again = false): void {
    this.question(performance.now(), again);
    this.refresh();
  }
  /** @param at_ms  when the hand asked */
  private question(at_ms: number, again = false): void {
    if (this.isFamily) return this.forget();
    this.planner.ask(
      {
        arm: this.armName, model: this.model, environment: this.environment,
        time_limit_s: this.timeLimit_s, tree: this.view.tree, limit_scale: this.limitScale, margin_m: this.margin_m,
      },
      at_ms,
      again,
    );
  }

  /** Ends what the studio does for this page, but for its arm. */
  endWork(): void {
    if (this.tab !== '') void post('stop', { tab: this.tab }).catch(() => {}); // it has ended then
  }

  /** The plan, and the search for it. */
  private forget(): void {
    if (this.planner.searching) this.endWork();
    this.planner.forget();
  }

  private armChanged(): void {
    showArmState(this);
    this.refresh();
  }

  /** The environment as one step of its history. */
  edit(environment: Environment): void {
    if (this.stage.isHeld) return; // the hand's next move would take it back
    this.history.set(environment);
    this.edited();
  }
  /** @param dragged_ms  when a hand moved something that it holds: then the plan is asked for first */
  edited(dragged_ms?: number): void {
    if (this.live) this.question(dragged_ms ?? performance.now());
    else this.forget(); // its plan is of another scene
    if (dragged_ms === undefined) this.refresh();
    else if (this.live) this.late ??= setTimeout(() => this.refreshSoon(), kPlanIsNear_ms);
    else this.refreshSoon();
  }
  select(selected: Selection): void {
    this.selected = selected;
    this.refresh();
  }
  add(kind: string): void {
    if (this.stage.isHeld) return;
    const { width, height } = this.stage.camera;
    const middle = toWorld(this.stage.camera, [width / 2, height / 4]);
    this.selected = this.environment.obstacles.length;
    this.edit(added(this.environment, newObstacle(kind, middle)));
    byId('canvas').focus();
  }
  removeSelected(): void {
    if (typeof this.selected !== 'number' || this.stage.isHeld) return;
    const gone = this.selected;
    this.selected = null;
    this.edit(removed(this.environment, gone));
    byId('canvas').focus();
  }
  undo(): void {
    this.turnBack(() => this.history.undo());
  }
  redo(): void {
    this.turnBack(() => this.history.redo());
  }
  private turnBack(turn: () => void): void {
    if (this.stage.isHeld) return; // a drag under way would be half in the past
    const before = this.environment;
    turn();
    this.selected = stillSelected(this.selected, before, this.environment);
    this.edited();
  }

  refresh(): void {
    if (!this.arm) return;
    this.entered.refresh();
    this.stage.draw();
  }

  /** With the next frame of the screen, however much happens until then. */
  private refreshSoon(draws = true): void {
    if (draws) this.stage.draw();
    if (this.due) return;
    this.due = true;
    requestAnimationFrame(() => {
      this.due = false;
      this.entered.refresh();
    });
  }
  private painted(): void {
    clearTimeout(this.late);
    this.late = undefined;
    this.latency.measure();
  }

  scene(): Scene {
    return {
      arm: this.arm ?? null,
      environment: this.environment,
      selected: null,
      plan: null,
      stale: false,
      showTree: null,
      showTube: false,
      showReach: this.view.reach,
      figures: [],
      ...(this.arm ? this.entered.scene() : {}),
    };
  }

  private down(at: Point, reach_m: number, event: PointerEvent): boolean {
    byId('canvas').focus({ preventScroll: true });
    return event.button <= 0 && (this.entered.down?.(at, reach_m) ?? false);
  }
}
