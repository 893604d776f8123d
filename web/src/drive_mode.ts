import { type Drive, type Family, get, post, type TrackKey } from './api';
import type { App } from './app';
import { button, facts, h } from './dom';
import type { Point } from './environment';
import { exportRow } from './export';
import type { Mode } from './mode';
import { trackNames } from './names';
import { cm, driveSliders, familySliders } from './panels';
import type { Figure, Scene } from './picture';
import { distance, lengthen, tipOf } from './shape';

const kKeys: Exclude<TrackKey, 'arm'>[] = ['virtual_arm', 'network', 'simple'];

/** Pressures by hand: every model gets the same ones at once. */
export class DriveMode implements Mode {
  private now: Drive | null = null;
  private trails = new Map<TrackKey, Point[]>();
  private target: number[] = [];
  private family: Family = { is_family: false, e: [], traits: [] };
  private e: number[] = []; // the arm of the family; empty: as the model stands
  private showsAll = false;
  private arms = h('section', { hidden: true });
  private request = 0;
  private sending = false;
  private waiting = false;
  private sliders = h('div');
  private readout = h('div', { id: 'readout' });

  constructor(private readonly app: App) {}

  enter(panel: HTMLElement): void {
    panel.append(
      h('section', {}, h('h2', {}, `Set points, ${this.app.unit}`), this.sliders,
        h('div', { class: 'row' },
          button('All to zero', () => this.set(this.target.map(() => 0))),
          button('Start again from rest', () => this.restart()))),
      this.arms,
      h('section', {}, h('h2', {}, 'Tips'), this.readout,
        h('p', { class: 'hint' }, 'Bend the arm and go back to zero: the simple model returns to where it was. ' +
          'The virtual arm, held by friction, does not quite.')),
      h('section', {}, h('h2', {}, 'Save the picture'), exportRow(this.app)),
    );
    this.e = [];
    this.arms.hidden = true;
    this.restart();
    if (this.app.model !== '') void this.app.attempt(() => this.openFamily(this.app.model));
  }

  private async openFamily(model: string): Promise<void> {
    this.family = await get<Family>('model', { name: model });
    if (model !== this.app.model || this.family.e.length === 0) return;
    this.showFamily();
  }
  private showFamily(): void {
    const { family } = this;
    const become = (e: number[]) => {
      this.e = e;
      void this.send(false);
    };
    this.arms.hidden = false;
    this.arms.replaceChildren(
      h('h2', {}, family.is_family ? 'Which arm of the family' : 'Another arm of the model’s family'),
      h('p', { class: 'hint' }, 'The network becomes that arm. The virtual arm stays as it is.'),
      familySliders(family, this.e.length ? this.e : family.e, this.showsAll, become, () => {
        this.showsAll = !this.showsAll;
        this.showFamily();
        this.arms.querySelector<HTMLElement>('[aria-expanded]')?.focus();
      }),
      h('div', { class: 'row' }, button(family.is_family ? 'The family’s middle' : 'The model’s own arm', () => {
        become([]);
        this.showFamily();
      })));
  }

  leave(): void {
    this.now = null;
    this.app.endWork();
  }

  private restart(): void {
    this.trails.clear();
    this.now = null;
    ++this.request;
    this.set(this.app.arm.segments.map(() => 0), true);
  }

  private set(target: number[], restart = false): void {
    this.target = target;
    this.sliders.replaceChildren(
      driveSliders(this.app.arm, target, (i, kpa) => {
        this.target = this.target.map((old, k) => (k === i ? kpa : old));
        void this.send(false);
      }));
    void this.send(restart);
  }

  /** One request at a time; the newest set points follow it. */
  private async send(restart: boolean): Promise<void> {
    if (this.sending && !restart) {
      this.waiting = true;
      return;
    }
    const { app } = this;
    this.sending = true;
    await app.attempt(() =>
      post('drive', {
        tab: app.tab, request: this.request, arm: app.armName, model: app.model,
        setpoint_kpa: this.target, e: this.e, restart,
      }));
    this.sending = false;
    if (this.waiting) {
      this.waiting = false;
      void this.send(false);
    }
  }

  onDrive(drive: Drive): void {
    if (drive.request !== this.request) return;
    this.now = drive;
    for (const key of kKeys) {
      const shape = drive[key];
      if (!shape) continue;
      const trail = this.trails.get(key) ?? [];
      lengthen(trail, shape);
      this.trails.set(key, trail);
    }
    this.app.refresh();
  }

  onFault(_request: number, message: string): void {
    this.app.say(message);
  }

  refresh(): void {
    const { now } = this;
    if (!now) return;
    const rest = tipOf(this.app.arm.rest);
    this.readout.replaceChildren(
      h('p', {}, 'Distance of each tip from where it lay at rest'),
      facts(kKeys.flatMap((key): [string, string][] => {
        const shape = now[key];
        return shape ? [[trackNames[key], cm(distance(tipOf(shape), rest))]] : [];
      })));
  }

  scene(): Partial<Scene> {
    const { now } = this;
    const figures = kKeys.flatMap((key): Figure[] => {
      const shape = now?.[key];
      if (!now || !shape) return [];
      const main = key === (now.virtual_arm ? 'virtual_arm' : 'simple');
      return [{
        shape, colour: key, trail: this.trails.get(key), outlined: !main,
        pressures_kpa: main ? now.setpoint_kpa : undefined,
      }];
    });
    return { environment: null, figures, showReach: false };
  }

  legend(): [string, string][] {
    return [
      ...kKeys.filter((key) => key !== 'network' || this.app.model !== '')
        .map((key): [string, string] => [key, trackNames[key]]),
      ['pressure', 'Pressurised side'],
    ];
  }
}
