// The page that one sends to a colleague: a motion to play, in one file, without the studio.

import { type Animation, motionOf } from './animation_data';
import { fitted } from './camera';
import { byId, h } from './dom';
import { drawingOf } from './drawing';
import { durationOf, environmentAt, figuresAt, mainOf } from './motion';
import { tracksPanel } from './panels';
import { Player } from './player';
import { chartsOf, Plots } from './plots';

const data = JSON.parse(byId('data').textContent!) as Animation;
const { arm, environment } = data;
const motion = motionOf(data);
const shown = new Set(motion.tracks.map(({ key }) => key));
const duration_s = durationOf(motion);
const stage = byId('stage');

const player: Player = new Player(() => duration_s, draw);
const plots: Plots = new Plots((at_s) => player.seek(at_s));

function draw(time_s = player.time_s): void {
  const { clientWidth: width, clientHeight: height } = stage;
  const reach_m = arm.length_m;
  const camera = fitted({ x: 0, y: 0, m_per_px: 1, width, height }, [-0.12 * reach_m, -0.78 * reach_m], [1.12 * reach_m, 0.78 * reach_m]);
  stage.innerHTML = drawingOf({
    arm, environment: environmentAt(environment, motion, time_s), selected: null, plan: null, stale: false,
    showTree: null, showTube: false, showReach: false, figures: figuresAt(motion, shown, time_s),
  }, camera);
  plots.at(time_s);
}
function plot(): void {
  plots.show(chartsOf(motion, mainOf(motion), environment.goal, data.unit), motion.frame_rate_hz, shown);
}

byId('panel').replaceChildren(
  h('section', {}, player.element),
  h('section', {}, tracksPanel(motion, shown, () => {
    plot();
    draw();
  })),
  h('section', {}, plots.element));
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => draw());
new ResizeObserver(() => draw()).observe(stage);
plot();
player.seek(0);
