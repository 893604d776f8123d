import { beforeEach, expect, it } from 'vitest';
import { ArmPanel } from '../src/arm_panel';
import { planPanel, scaleChoice } from '../src/panels';
import { fakePage, type FakeElement } from './fake_page';

beforeEach(() => void fakePage());

it('a share of the limits that was chosen elsewhere is offered, and chosen, in its place', () => {
  const options = (chosen: number, highest?: number) => {
    const select = scaleChoice('Share', chosen, () => {}, highest) as unknown as FakeElement;
    const words = (all: FakeElement[]) => all.map((one) => one.textContent);
    const all = select.children as FakeElement[];
    return [words(all), words(all.filter((one) => one.getAttribute('selected') !== null))];
  };
  expect(options(0.25)).toEqual([
    ['10 %', '20 %', '25 %', '30 %', '40 %', '50 %', '60 %', '70 %', '80 %', '90 %', '100 %'], ['25 %']]);
  expect(options(0.1, 0.25)).toEqual([['10 %', '20 %', '25 %'], ['10 %']]);
  expect(options(0.25, 0.25)).toEqual([['10 %', '20 %', '25 %'], ['25 %']]);
});

it('a clearance with which there is a plan is a button, not a flag', () => {
  const kept: number[] = [];
  const panelOf = (reason: string) =>
    planPanel({ result: { status: 'limit', reason } } as never, 'kPa', false, (m) => kept.push(m)) as unknown as FakeElement;
  const panel = panelOf('5 s; with less clearance than the 0.53 cm asked for there is a plan, which keeps 0.41 cm: --margin-m 0.003975');
  expect(panel.textContent).toBe('No plan found' + '5 s; with less clearance than the 0.53 cm asked for there is a plan, which keeps 0.41 cm' + 'Keep 0.40 cm');
  panel.all.find((part) => part.getAttribute('type') === 'button')!.fire('click');
  expect(kept).toEqual([0.003975]);
  const other = panelOf('5 s; 0.40 cm of the tolerance are kept for the model\'s error: --goal-margin-m 0 keeps none; so');
  expect(other.textContent).toMatch(/model's error; so$/);
});

it('an arming begins with no more than the studio was started with', () => {
  const status = { state: 'off', message: '', recording: '' };
  const armLink = { status, isMine: false, isSeen: true, arm: async () => {} };
  const panel = new ArmPanel({
    project: { driver: 'exec:mine', driver_arm: 'a', driver_limit_scale: 0.05 }, armName: 'a', armLink,
    attempt: (work: () => Promise<void>) => work(), refresh: () => {},
  } as never);
  panel.refresh(null);
  const all = (panel.element as unknown as FakeElement).all;
  all.find((one) => one.textContent === 'Arm' && one.getAttribute('type'))!.fire('click');
  expect(panel.limitScale).toBe(0.05);
});
