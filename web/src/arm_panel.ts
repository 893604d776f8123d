import type { Plan } from './api';
import type { App } from './app';
import { button, checkbox, field, h, refill } from './dom';
import { neededScale, scaleChoice } from './panels';

const kFirstScale = 0.1;

/** Arms the arm behind the driver, says how far it may go, and what becomes of it. */
export class ArmPanel {
  readonly element = h('div', { id: 'arm-panel' });
  limitScale = kFirstScale;
  private drawn = '';
  private isConfirmed = false;

  constructor(private readonly app: App) {}

  /** Whether there is one, and what is shown is planned for it. */
  get isThere(): boolean {
    const { project, armName } = this.app;
    return project.driver !== '' && armName === project.driver_arm;
  }
  /** Whether Play moves it. */
  get isChosen(): boolean {
    return this.isThere && this.app.armLink.isMine;
  }

  /** Redraws only what has changed: somebody may be at a control. */
  refresh(plan: Plan | null): void {
    if (!this.isThere) return;
    const { status, isMine, isSeen, live } = this.app.armLink;
    const needed = plan ? neededScale(this.app.arm, plan.setpoints_kpa) : 0;
    const shown = JSON.stringify([status, isMine, isSeen, live?.holds, live?.noticed, this.limitScale, this.isConfirmed, needed]);
    if (shown === this.drawn) return;
    this.drawn = shown;
    refill(this.element, ...this.parts(needed));
  }

  private parts(needed: number): HTMLElement[] {
    const { armLink, project } = this.app;
    const { state, message, recording } = armLink.status;
    const parts: HTMLElement[] = [h('p', { class: 'hint' }, project.driver)];
    if (!armLink.isSeen) {
      parts.push(h('p', { class: 'warning' }, 'The studio is not heard: what the arm does is not known.'));
    } else if (state === 'running') {
      const holds = armLink.live?.holds ?? '';
      parts.push(h('p', { class: 'status busy' }, h('strong', {}, holds ? `Holds: ${holds}` : 'Moves')));
      if (armLink.live?.noticed) parts.push(h('p', { class: 'warning' }, armLink.live.noticed));
    } else if (state === 'armed' && !armLink.isMine) {
      parts.push(h('p', {}, 'Another page has armed the arm.'));
    } else if (armLink.isMine) {
      parts.push(...this.armedParts(needed));
    } else {
      const arm = button('Arm', () => void this.app.attempt(async () => {
        this.isConfirmed = false;
        this.limitScale = Math.min(kFirstScale, project.driver_limit_scale);
        await armLink.arm();
      }), { class: 'danger' });
      arm.disabled = !this.isConfirmed;
      parts.push(
        checkbox('Nobody is within its reach, and I can shut off the supply', this.isConfirmed, (on) => {
          this.isConfirmed = on;
          this.app.refresh();
        }),
        h('div', { class: 'row' }, arm));
    }
    if (message) parts.push(h('p', { class: armLink.isAlarm ? 'alarm' : 'outcome' }, message)); // read out below VENT
    if (recording) parts.push(h('p', { class: 'hint' }, `Recorded: ${recording}`));
    return parts;
  }

  private armedParts(needed: number): HTMLElement[] {
    const { app } = this;
    const scales = scaleChoice('Share of the pressure limits that the arm may use', this.limitScale, (scale) => {
      this.limitScale = scale;
      app.refresh();
    }, app.project.driver_limit_scale);
    const isBeyond = needed > this.limitScale + 1e-3;
    return [
      h('p', {}, h('strong', {}, 'Armed.'), ' Play moves it; Space, Escape and VENT vent it at once.'),
      field('Limits', scales),
      h('p', { class: isBeyond ? 'warning' : 'hint' }, `This plan needs ${Math.ceil(100 * needed - 0.1)} % of the limits.`),
      h('div', { class: 'row' },
        isBeyond && button(`Plan within ${Math.round(100 * this.limitScale)} %`, () => {
          app.limitScale = this.limitScale;
          app.enter('plan');
          app.ask();
        }),
        button('Disarm', () => void app.attempt(() => app.armLink.disarm()))),
    ];
  }
}
