import { type Environment, type Fitted, type Fitting, type Plan, post, Refusal } from './api';
import type { App } from './app';
import { button, byId, changeText, checkbox, choice, field, h, refill, tool } from './dom';
import { dragged, type Handle, hit, type Point, type Selection } from './environment';
import { exportRow } from './export';
import type { Mode } from './mode';
import { cm, familyPanel, planPanel, scaleChoice, selectionPanel, thingsList } from './panels';
import type { Scene } from './picture';

/** Arm, obstacles and goal by hand; a plan that follows. */
export class PlanMode implements Mode {
  private things = h('div');
  private selection = h('div');
  private status = h('div', { id: 'status' });
  private drawn: [Environment, Selection] | null = null; // what the lists show
  private request = 0; // of fitting
  private fitting = ''; // what is being done; empty: nothing
  private tube = h('label');
  private buttons: Record<'undo' | 'redo' | 'stop' | 'savePlan', HTMLButtonElement> | null = null;
  private grip: { handle: Handle; from: Point; begin: Environment } | null = null;
  private nameOf: Environment | null = null; // as opened or saved
  private name = h('input', { type: 'text', id: 'name', 'aria-label': 'Name to save as' });

  constructor(private readonly app: App) {}

  enter(panel: HTMLElement): void {
    const { app } = this;
    const { project } = app;
    this.drawn = null;
    const undo = button('↶', () => app.undo(), { title: 'Undo (Ctrl+Z)', 'aria-label': 'Undo' });
    const redo = button('↷', () => app.redo(), { title: 'Redo (Ctrl+Y)', 'aria-label': 'Redo' });
    const stop = button('Stop', () => void app.attempt(() => app.planner.stop()));
    const savePlan = button('Save plan', () => void app.attempt(() => this.savePlan()));
    this.buttons = { undo, redo, stop, savePlan };
    byId('tools').replaceChildren(
      tool('●', 'Add a circle', () => app.add('circle')),
      tool('■', 'Add a rectangle', () => app.add('rectangle')),
      tool('▲', 'Add a polygon', () => app.add('polygon')),
      h('i'), undo, redo, h('i'),
    );
    const reopen = (open: () => Promise<boolean>) =>
      void app.attempt(async () => {
        let isOpen = false;
        try {
          isOpen = await open();
        } finally {
          if (isOpen) app.reopened();
          else this.show(); // what is open is chosen again
        }
      });
    const toggle = (label: string, key: keyof App['view']) =>
      checkbox(label, app.view[key], (on) => {
        app.view[key] = on;
        if (key === 'tree' && on && app.planner.tree === null) app.ask();
        else app.refresh();
      });
    this.tube = toggle('Tube', 'tube');
    const limits = h('select', { 'aria-label': 'Seconds to search for' },
      ...[1, 5, 20].map((s) => h('option', { value: s, selected: s === app.timeLimit_s }, `${s} s`)));
    limits.addEventListener('change', () => (app.timeLimit_s = Number(limits.value)));
    const scales = scaleChoice('Share of the pressure limits to plan with', app.limitScale, (scale) => {
      app.limitScale = scale;
      app.ask();
    });
    if (this.nameOf !== app.saved) this.name.value = app.environment.name; // of another document
    this.nameOf = app.saved;
    const { margin_m } = app;
    panel.append(
      h('section', {}, this.status,
        margin_m === null ? '' : h('p', { class: 'warning' }, `Plans keep ${cm(margin_m)} from obstacles, less than the model’s error asks for. `,
          button('Keep all of it', () => this.keep(null))),
        h('div', { class: 'row' },
          button('Plan', () => app.ask(true), { class: 'main' }), stop, savePlan),
        h('div', { class: 'checks' },
          checkbox('Plan while dragging', app.live, (on) => (app.live = on)),
          toggle('Search tree', 'tree'), this.tube, toggle('Reach', 'reach')),
        h('div', { class: 'row' }, field('Search for', limits), field('Pressures', scales))),
      h('section', {}, h('h2', {}, 'Scene'),
        field('Arm', choice(project.arms, app.armName, (name) =>
          reopen(async () => {
            if (!app.mayLose('Open another arm?')) return false;
            return (await app.open(name, app.environmentName)) && app.choose(app.modelBefore());
          }))),
        field('Model', choice(project.models, app.model, (name) =>
          reopen(async () => app.choose(name)), 'Simple model',
          (name) => (project.families.includes(name) ? ' (family)' : ''))),
        field('Environment', choice(project.environments, app.environmentName, (name) =>
          reopen(async () =>
            app.mayLose('Open another environment?') && app.open(app.armName, name)))),
        project.plans.length > 0 && field('Saved plan', choice(project.plans, '', (name) => this.openPlan(name), 'Open …')),
        field('Name', this.name),
        h('div', { class: 'row' }, button('Save environment', () => void app.attempt(async () => this.said(await this.saveEnvironment()))),
          button('Copy link', () => void app.attempt(() => this.copyLink()),
            { title: 'A link that restores the scene' }))),
      h('section', {}, h('h2', {}, 'Goal and obstacles'), this.things, this.selection),
      h('section', {}, h('h2', {}, 'Save the picture'), exportRow(app)),
    );
  }

  leave(): void {
    const { app } = this;
    byId('tools').replaceChildren();
    changeText(byId('said'), '');
    this.grip = null; // of a scene that may be another one by now
    app.history.end();
    if (app.planner.searching || this.fitting) app.endWork();
    app.planner.giveUp();
    app.planner.end();
    this.endFitting();
  }
  private endFitting(): void {
    this.fitting = '';
    ++this.request;
  }
  private openPlan(name: string): void {
    const { app } = this;
    if (app.mayLose('Open the plan?')) {
      this.endFitting(); // the tab does one thing at a time
      app.opening.ask(name, () => {
        app.enter('plan');
        app.say(`Opened ${name}: its certificate was checked again, and holds`);
      });
    }
    this.show(); // nothing is chosen in the list
  }
  /** The clearance of plans from now on; null: what the model's error asks for. */
  private keep(margin_m: number | null): void {
    this.app.margin_m = margin_m;
    this.app.show();
    this.app.ask();
  }
  /** The panel again, unless it was left. */
  private show(): void {
    if (this.name.isConnected) this.app.show();
  }

  down(at: Point, reach_m: number): boolean {
    const { app } = this;
    const handle = hit(app.environment, app.selected, at, reach_m);
    app.select(handle ? handle.of : null);
    if (!handle) return false;
    this.grip = { handle, from: at, begin: app.environment };
    app.history.begin();
    return true;
  }
  drag(at: Point, at_ms: number): void {
    if (!this.grip) return;
    this.app.history.change(dragged(this.grip.begin, this.grip.handle, this.grip.from, at));
    this.app.edited(at_ms);
  }
  up(): void {
    this.grip = null;
    this.app.history.end();
    this.app.refresh();
    this.app.planner.hurry();
  }

  refresh(): void {
    const { app, buttons } = this;
    if (!buttons) return;
    buttons.undo.disabled = !app.history.canUndo;
    buttons.redo.disabled = !app.history.canRedo;
    buttons.stop.disabled = !app.planner.searching;
    buttons.savePlan.disabled = !app.planner.plan || !app.planner.isCurrent;
    this.showTube(app.planner.plan);
    refill(this.status, app.isFamily
      ? familyPanel(this.fitting, () => void this.fit())
      : planPanel(app.planner, app.unit, app.model === '', (margin_m) => this.keep(margin_m)));
    changeText(byId('said'), this.status.querySelector('strong')?.firstChild?.textContent ?? '');
    if (this.drawn?.[0] === app.environment && this.drawn[1] === app.selected) return; // somebody may be typing
    if (app.stage.isHeld) return; // their numbers follow when the hand lets go
    this.drawn = [app.environment, app.selected];
    refill(this.things, thingsList(app.environment, app.selected, (what) => app.select(what)));
    refill(this.selection,
      selectionPanel(app.environment, app.selected, (next) => app.edit(next), () => app.removeSelected()));
  }

  /** Its box can't be ticked where the plan has none, and says why. */
  private showTube(plan: Plan | null): void {
    const hasNone = plan !== null && plan.tube === null;
    const box = this.tube.querySelector('input');
    if (box === null || box.disabled === hasNone) return;
    box.disabled = hasNone;
    this.tube.lastChild!.textContent = hasNone ? 'Tube: none in this plan; limber calibrate gives one' : 'Tube';
  }

  scene(): Partial<Scene> {
    const { app } = this;
    const { plan, isCurrent } = app.planner;
    const { backbone } = app.environment.start as { backbone?: number[][] };
    const start = backbone?.flat(); // a link's may be of an arm with other plates
    return {
      selected: app.selected,
      plan,
      stale: !isCurrent,
      showTree: app.view.tree ? app.planner.tree : null,
      showTube: app.view.tube,
      figures: [
        { shape: start?.length === app.arm.rest.length ? start : app.arm.rest, colour: 'plate' },
        ...(plan && isCurrent ? [{ shape: plan.shapes[plan.shapes.length - 1], colour: 'plan', outlined: true } as const] : []),
      ],
    };
  }

  legend(): [string, string][] {
    return [['plan', 'Plan'], ['goal', 'Goal'], ['reach', 'Reached by the simple model, at rest']];
  }

  /** The environment under the name that is typed. */
  private named(): Environment {
    return { ...this.app.environment, name: this.name.value };
  }
  private async copyLink(): Promise<void> {
    const { app } = this;
    const link = app.link(this.named());
    const isCopied = await navigator.clipboard?.writeText(link).then(() => true, () => false);
    app.say(isCopied
      ? 'Copied: a link that restores the scene'
      : 'The page’s address now restores the scene: copy it from there');
  }

  /** Has the studio make the family the virtual arm's own. */
  private async fit(): Promise<void> {
    const { app } = this;
    this.onFitting({ request: ++this.request, step: 'Asked for …' });
    await app.attempt(async () => {
      try {
        await post('fit', { tab: app.tab, request: this.request, arm: app.armName, model: app.model });
      } catch (error) {
        this.onFitting({ request: this.request, step: '' });
        throw error;
      }
    });
  }
  onFitting({ request, step }: Fitting): void {
    if (request !== this.request) return;
    this.fitting = step;
    this.app.refresh();
  }
  onFault(request: number, message: string): void {
    const { app } = this;
    if (!app.isFamily) return app.planner.onFault(request, message);
    this.onFitting({ request, step: '' });
    app.say(message);
  }
  async onFitted({ request, model, error_cm }: Fitted): Promise<void> {
    if (request !== this.request) return;
    const { app } = this;
    this.fitting = '';
    await app.readProject();
    app.choose(model);
    app.reopened();
    app.say(`Fitted: ${model}` + (error_cm === null ? '' : `, ${error_cm.toFixed(1)} cm off on seconds that it had not seen`));
  }

  /** The plan; before it its environment, which limber verify compares, where no file has that yet. */
  private async savePlan(): Promise<void> {
    const { app } = this;
    const name = this.name.value;
    const { number } = app.planner; // another plan may be there when the environment is saved
    const environment = app.isChanged || !app.isInFile ? await this.saveEnvironment() : '';
    if (environment === null) return;
    const plan = await this.save('plan/save', { plan: number }, name);
    if (plan !== null) this.list('plans', plan);
    this.said(plan, environment);
  }
  /** The environment's file becomes what is open, unless that has changed meanwhile. @return as `save` */
  private async saveEnvironment(): Promise<string | null> {
    const { app } = this;
    const from = app.environment;
    const environment = this.named();
    const name = await this.save('environment', { arm: app.armName, environment });
    if (name === null) return null;
    if (app.environment === from) {
      app.history.change(environment); // no step: undo would take back nothing that is seen
      this.nameOf = app.saved = environment;
      app.isInFile = true;
      app.environmentName = name;
      app.link();
    }
    this.list('environments', name);
    return name;
  }
  /** Among the project's files too, from now on. */
  private list(kind: 'environments' | 'plans', name: string): void {
    const { app } = this;
    app.project = { ...app.project, [kind]: [...new Set([...app.project[kind], name])] };
    this.show();
  }
  private said(name: string | null, first = ''): void {
    if (name !== null) this.app.say(`Saved ${first && `${first} and `}${name}`);
  }
  /**
   * Asks before it replaces a file, and replaces the one that it has asked about.
   * @param typed  another one may be typed meanwhile
   * @return what was written; null: nothing
   */
  private async save(path: string, body: object, typed = this.name.value): Promise<string | null> {
    const { app } = this;
    const send = async (overwrite: boolean): Promise<string> =>
      (await post<{ name: string }>(path, { ...body, tab: app.tab, name: typed.trim(), overwrite })).name;
    try {
      return await send(false);
    } catch (error) {
      if (!(error instanceof Refusal) || error.status !== 412) throw error;
      return app.confirms(`${error.message}. Replace it?`) ? send(true) : null;
    }
  }
}
