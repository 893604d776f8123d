import type { App } from './app';
import { byId, changeText } from './dom';

const kUnanswered = 'VENT is not answered: shut off the supply.';

/** VENT and its keys, from when the project is known. */
export function offerVent(app: App): void {
  const { driver } = app.project;
  byId('arm').hidden = driver === '';
  if (driver !== '') app.armLink.prepare();
  const vent = () => void app.attempt(() => app.armLink.vent());
  // As soon as it is pressed; a click is that of a keyboard or an assistive technology too.
  for (const kind of ['pointerdown', 'click']) byId('vent').addEventListener(kind, vent);
  document.addEventListener('keydown', (event) => onVentKey(app, event, vent), { capture: true });
}

/**
 * While the arm moves, before anybody else gets them; and on the page that has armed it, where
 * Space would else press Play once more just after a run's end.
 */
function onVentKey(app: App, event: KeyboardEvent, vent: () => void): void {
  const { runs, isMine } = app.armLink;
  const isField = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
  if ((event.key !== ' ' && event.key !== 'Escape') || !(runs || (isMine && !isField))) return;
  event.preventDefault();
  event.stopImmediatePropagation();
  if (!event.repeat) vent();
}

/** The arm's state beside the button, and below it what became of it last: in every mode. */
export function showArmState({ armLink }: App): void {
  const { status: { state, message }, isMine, isSeen, isVenting, isUnanswered } = armLink;
  const words = { off: '', armed: isMine ? 'armed here' : 'armed by another page', running: 'the arm moves' };
  changeText(byId('arm-state'), isVenting ? 'Venting …' : isSeen ? words[state] : 'the arm is not seen');
  byId('arm-state').className = isSeen ? state : 'lost';
  const line = byId('arm-message');
  const isAlarm = isUnanswered || armLink.isAlarm;
  line.className = isAlarm ? 'alarm' : 'outcome';
  line.setAttribute('role', isAlarm ? 'alert' : 'status'); // before the words, which it is read with
  changeText(line, isUnanswered ? kUnanswered : message);
}
