// The page that one sends to a colleague: a motion to play, in one file, without the studio.

import { type Animation, motionOf } from './animation_data';
import { fitted } from './camera';
import { button, byId, h } from './dom';
import { drawingOf } from './drawing';
import { durationOf, environmentAt, figuresAt, mainOf } from './motion';
import { tracksPanel } from './panels';
import { chartsOf, Plots } from './plots';

const data = JSON.parse(byId('data').textContent!) as Animation;
const { arm, environment } = data;
const motion = motionOf(data);
const shown = new Set(motion.tracks.map(({ key }) => key));
const duration_s = durationOf(motion);
const stage = byId('stage');

let time_s = 0;
let playing = false;
const plots = new Plots((at_s) => {
  playing = false;
  seek(at_s);
});
const slider = h('input', { type: 'range', min: 0, max: duration_s, step: 'any', value: 0, 'aria-label': 'Time in seconds' });
const clock = h('output');
const press = button('Play', toggle, { class: 'main' });
slider.addEventListener('input', () => {
  playing = false;
  seek(slider.valueAsNumber);
});

function draw(): void {
  const { clientWidth: width, clientHeight: height } = stage;
  const reach_m = arm.length_m;
  const camera = fitted({ x: 0, y: 0, m_per_px: 1, width, height }, [-0.12 * reach_m, -0.78 * reach_m], [1.12 * reach_m, 0.78 * reach_m]);
  stage.innerHTML = drawingOf({
    arm, environment: environmentAt(environment, motion, time_s), selected: null, plan: null, stale: false,
    showTree: null, showTube: false, showReach: false, figures: figuresAt(motion, shown, time_s),
  }, camera);
  slider.value = String(time_s);
  clock.textContent = `${time_s.toFixed(1)} s`;
  press.textContent = playing ? 'Pause' : 'Play';
  plots.at(time_s);
}
function seek(at_s: number): void {
  time_s = Math.max(0, Math.min(at_s, duration_s));
  draw();
}
function toggle(): void {
  playing = !playing;
  if (playing && time_s >= duration_s) time_s = 0;
  let last_ms = performance.now();
  const step = (now_ms: number): void => {
    if (!playing) return;
    const next_s = time_s + Math.max(0, now_ms - last_ms) / 1000;
    last_ms = now_ms;
    if (next_s >= duration_s) playing = false;
    else requestAnimationFrame(step);
    seek(next_s);
  };
  if (playing) requestAnimationFrame(step);
  draw();
}
function plot(): void {
  plots.show(chartsOf(motion, mainOf(motion), environment.goal, data.unit), motion.frame_rate_hz, shown);
}

byId('panel').replaceChildren(
  h('section', {}, h('div', { class: 'play' }, press, slider, clock)),
  h('section', {}, tracksPanel(motion, shown, (key, on) => {
    if (on) shown.add(key);
    else shown.delete(key);
    plot();
    draw();
  })),
  h('section', {}, plots.element));
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);
new ResizeObserver(draw).observe(stage);
plot();
draw();
