// The page that `limber evaluate --plots` writes of an arm in space: recorded and predicted shapes, which can be turned.

import { byId, button, checkbox, h } from './dom';
import { unpacked } from './packing';
import { Player } from './player';
import { axesOf, dot, tilted, type Vector, type View } from './turning';

type Data = {
  frame_rate_hz: number; plates: number; length_m: number; gravity: Vector; unit_m: number;
  // colour: a variable of style.css; unknown: frames that were not seen or not predicted
  tracks: { name: string; color: string; places: string; unknown: number[] }[];
};
const data = JSON.parse(byId('data').textContent!) as Data;
const tracks = data.tracks.map(({ name, color, places, unknown }) => ({
  name, color, on: true, frames: unpacked(places, 3 * data.plates, [data.unit_m]), unknown: new Set(unknown),
  figure: h('output')
}));
const recorded = tracks[0];
const last = recorded.frames.length - 1;
const kStart: View = { turn_rad: -0.6, tilt_rad: 0.3 };
const kStep_rad = Math.PI / 36; // of an arrow key
const kRadPerPx = 0.008;
const kTrail_s = 2;

let view = kStart;
let zoom = 1;
const canvas = h('canvas', { tabindex: 0, role: 'img', 'aria-label': 'The arm; arrow keys turn it, plus and minus zoom, Home resets' });
const stage = byId('stage');
const pointAt = (frame: number[], plate: number): Vector => [frame[3 * plate], frame[3 * plate + 1], frame[3 * plate + 2]];

const apart = (a: Vector, b: Vector): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const tipOf = (frame: number[]): Vector => pointAt(frame, data.plates - 1);

// The middle of all that was recorded, and how far it reaches from there, whatever it is looked at from.
const places = recorded.frames.flatMap((frame) => Array.from({ length: data.plates }, (_, plate) => pointAt(frame, plate)));
const middle = [0, 1, 2].map((axis) => {
  const [low, high] = places.reduce(([a, b], p) => [Math.min(a, p[axis]), Math.max(b, p[axis])], [Infinity, -Infinity]);
  return (low + high) / 2;
}) as Vector;
const radius_m = places.reduce((most, place) => Math.max(most, apart(place, middle)), 0) + 0.05 * data.length_m;
const farthest = recorded.frames.reduce((most, frame, t) =>
  (apart(tipOf(frame), tipOf(recorded.frames[0])) > apart(tipOf(recorded.frames[most]), tipOf(recorded.frames[0])) ? t : most), 0);

function draw(time_s = player.time_s): void {
  const { clientWidth: width, clientHeight: height } = stage;
  const scale = devicePixelRatio;
  canvas.width = width * scale;
  canvas.height = height * scale;
  const pen = canvas.getContext('2d')!;
  pen.scale(scale, scale);
  const style = getComputedStyle(canvas);
  const color = (name: string): string => style.getPropertyValue(name);
  const axes = axesOf(view, data.gravity);
  const px_per_m = (zoom * Math.min(width, height)) / (2 * radius_m);
  const at = (p: Vector): [number, number] => {
    const from = p.map((value, i) => value - middle[i]) as Vector;
    return [width / 2 + px_per_m * dot(from, axes.right), height / 2 - px_per_m * dot(from, axes.up)];
  };
  const line = (points: Vector[], stroke: string, width_px: number): void => {
    pen.beginPath();
    points.forEach((point, i) => (i ? pen.lineTo(...at(point)) : pen.moveTo(...at(point))));
    Object.assign(pen, { strokeStyle: stroke, lineWidth: width_px, lineJoin: 'round', lineCap: 'round' });
    pen.stroke();
  };
  const reach_m = 0.3 * data.length_m;
  pen.font = '13px system-ui, sans-serif';
  ([['x', [1, 0, 0]], ['y', [0, 1, 0]], ['z', [0, 0, 1]]] as [string, Vector][]).forEach(([name, axis]) => {
    const end = axis.map((value) => value * reach_m) as Vector;
    line([[0, 0, 0], end], color('--axis'), 1.5);
    pen.fillStyle = color('--quiet');
    const [x, y] = at(end.map((value) => value * 1.12) as Vector);
    pen.fillText(name, x - 4, y + 4);
  });
  const frame = Math.min(Math.round(time_s * data.frame_rate_hz), last);
  const first = Math.max(0, frame - Math.round(kTrail_s * data.frame_rate_hz));
  for (const track of tracks.filter(({ on }) => on)) {
    const stroke = color(track.color);
    pen.globalAlpha = 0.45;
    line(track.frames.slice(first, frame + 1).map(tipOf), stroke, 1);
    pen.globalAlpha = 1;
    const plates = Array.from({ length: data.plates }, (_, plate) => pointAt(track.frames[frame], plate));
    line(plates, stroke, track === recorded ? 5 : 2.5);
    pen.fillStyle = stroke;
    for (const plate of plates) {
      pen.beginPath();
      pen.arc(...at(plate), track === recorded ? 5 : 4, 0, 2 * Math.PI);
      pen.fill();
    }
  }
  for (const track of tracks.slice(1)) {
    const known = !track.unknown.has(frame) && !recorded.unknown.has(frame);
    const off_m = apart(tipOf(track.frames[frame]), tipOf(recorded.frames[frame]));
    track.figure.textContent = known ? `${(1000 * off_m).toFixed(1)} mm` : '–';
  }
}

function look(next: View, zoomed = zoom): void {
  view = next;
  zoom = Math.max(0.3, Math.min(zoomed, 10));
  draw();
}
const kKeys: Record<string, () => void> = {
  ArrowLeft: () => look(tilted(view, -kStep_rad, 0)), ArrowRight: () => look(tilted(view, kStep_rad, 0)),
  ArrowUp: () => look(tilted(view, 0, -kStep_rad)), ArrowDown: () => look(tilted(view, 0, kStep_rad)),
  '+': () => look(view, 1.2 * zoom), '-': () => look(view, zoom / 1.2), Home: () => look(kStart, 1),
};
canvas.addEventListener('keydown', (event) => {
  const act = kKeys[event.key];
  if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  act();
});

// One finger or the mouse turns, two fingers zoom.
const fingers = new Map<number, [number, number]>();
const spread = (): number => {
  const [a, b] = [...fingers.values()];
  return b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
};
canvas.addEventListener('pointerdown', (event) => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, [event.clientX, event.clientY]);
});
canvas.addEventListener('pointermove', (event) => {
  const from = fingers.get(event.pointerId);
  if (!from) return;
  const before = spread();
  fingers.set(event.pointerId, [event.clientX, event.clientY]);
  if (before > 0) look(view, (zoom * spread()) / before);
  else look(tilted(view, kRadPerPx * (event.clientX - from[0]), kRadPerPx * (event.clientY - from[1])));
});
for (const end of ['pointerup', 'pointercancel'] as const) canvas.addEventListener(end, (event) => fingers.delete(event.pointerId));
canvas.addEventListener('wheel', (event) => {
  event.preventDefault();
  look(view, zoom * 1.001 ** -event.deltaY);
}, { passive: false });

const player: Player = new Player(() => last / data.frame_rate_hz, draw);
const quarter = Math.PI / 2;
const views: [string, View][] = [
  ['Side', { turn_rad: 0, tilt_rad: 0 }], ['Front', { turn_rad: quarter, tilt_rad: 0 }],
  ['Above', { turn_rad: 0, tilt_rad: quarter }], ['Corner', kStart],
];
stage.replaceChildren(canvas);
byId('panel').replaceChildren(
  h('section', {}, player.element),
  h('section', {}, h('h2', {}, 'Look from'), h('div', { class: 'row' }, ...views.map(([name, one]) => button(name, () => look(one, 1)))),
    h('p', { class: 'hint' }, 'Drag, or arrow keys, turn the arm; the wheel, two fingers, or + and −, zoom.')),
  h('section', { class: 'shapes' }, h('h2', {}, 'Shown, and how far its tip is off'),
    ...tracks.map((track) => h('div', { style: `--of: var(${track.color})` },
      checkbox(track.name, true, (on) => {
        track.on = on;
        draw();
      }), track.figure))),
  h('section', { class: 'hint' }, ...[...document.querySelectorAll('#panel > ul > li')].map(({ textContent }) => h('p', {}, textContent))));
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => draw());
new ResizeObserver(() => draw()).observe(stage);
player.seek(farthest / data.frame_rate_hz);
