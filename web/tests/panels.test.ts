import { beforeEach, expect, it } from 'vitest';
import { ArmPanel } from '../src/arm_panel';
import { scaleChoice } from '../src/panels';
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
