import { beforeEach, expect, it } from 'vitest';
import { showArmState } from '../src/vent_button';
import { fakePage, type FakeElement } from './fake_page';

let byId: (id: string) => FakeElement;
beforeEach(() => {
  byId = fakePage();
});

/** Of an arm that this page sees, armed by another one. */
const shown = (link: object): void => showArmState({ armLink: {
  status: { state: 'armed', message: '', recording: '' }, isMine: false, isAlarm: false, isSeen: true, ...link,
} } as never);

it('what became of the arm stands beside VENT, and is an alarm where a vent is not confirmed', () => {
  const line = byId('arm-message');
  shown({ status: { state: 'off', message: 'vented: 0.8 kPa after 0.6 s' } });
  expect([line.textContent, line.className, line.getAttribute('role')])
    .toEqual(['vented: 0.8 kPa after 0.6 s', 'outcome', 'status']);
  shown({ status: { state: 'off', message: 'VENT NOT CONFIRMED: 31 kPa' }, isAlarm: true });
  expect([line.textContent, line.className, line.getAttribute('role')])
    .toEqual(['VENT NOT CONFIRMED: 31 kPa', 'alarm', 'alert']);
  shown({});
  expect(line.textContent).toBe('');
});

it('nothing is said of an arm whose studio is not heard', () => {
  for (const state of ['off', 'armed', 'running']) {
    shown({ status: { state, message: '' }, isMine: true, isSeen: false });
    expect([byId('arm-state').textContent, byId('arm-state').className]).toEqual(['the arm is not seen', 'lost']);
  }
  shown({ isMine: true });
  expect(byId('arm-state').textContent).toBe('armed here');
});

it('a VENT that is under way says so, and sends to the supply where nobody answers', () => {
  shown({ isVenting: true });
  expect([byId('arm-state').textContent, byId('arm-message').textContent]).toEqual(['Venting …', '']);
  shown({ isVenting: true, isUnanswered: true });
  expect(byId('arm-message').textContent).toBe('VENT is not answered: shut off the supply.');
  expect(byId('arm-message').getAttribute('role')).toBe('alert');
});
