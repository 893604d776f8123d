import * as THREE from 'three';
import { axisLabels, type Camera, fitted, panned, thingLabels, toWorld, zoomed } from './camera';
import { h } from './dom';
import type { Point } from './environment';
import { Painter } from './painter';
import { Picture, type Scene } from './picture';

/** What pointers do on the stage, in metres. */
export type StageEvents = {
  /** Something is grabbed: true; or the stage itself is moved: false. */
  down(at: Point, reach_m: number, event: PointerEvent): boolean;
  drag(at: Point, event: PointerEvent): void;
  /** @param isCut  by a second finger, or by the browser */
  up(isCut: boolean): void;
};

const kFinger_px = 22;
const kMouse_px = 9;

/** The canvas: draws when something has changed, zooms, pans, and tells where it is touched. */
export class Stage {
  camera: Camera = { x: 0.35, y: 0, m_per_px: 0.001, width: 1, height: 1 };
  private readonly renderer: THREE.WebGLRenderer;
  private readonly view = new THREE.OrthographicCamera();
  private readonly world = new THREE.Scene();
  private readonly painter = new Painter();
  private readonly picture: Picture;
  private readonly pointers = new Map<number, Point>();
  private readonly labels = h('div', { class: 'grid-labels', 'aria-hidden': 'true' });
  private grabbed = false;
  private due = false;
  private fitTo: [Point, Point] = [[-0.1, -0.5], [0.8, 0.5]];
  /** Called after each frame that was drawn. */
  painted: () => void = () => {};

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly scene: () => Scene,
    private readonly events: StageEvents,
  ) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // colours are those of the style sheet
    this.renderer.setClearColor(0, 0);
    this.picture = new Picture(this.painter, this.camera);
    this.world.add(this.painter.mesh);
    this.view.position.z = 1;
    canvas.after(this.labels);
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
      this.picture.recolour();
      this.draw();
    });
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', (event) => this.up(event));
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    canvas.addEventListener('webglcontextrestored', () => this.draw()); // three has set it up again
  }

  /** Whether a hand drags something on it. */
  get isHeld(): boolean {
    return this.grabbed;
  }

  /** With the next frame of the screen. */
  draw(): void {
    if (this.due) return;
    this.due = true;
    requestAnimationFrame(() => {
      if (this.due) this.drawNow();
    });
  }

  /** Shows that box, now and after a change of size. */
  fit(low: Point, high: Point): void {
    this.fitTo = [low, high];
    this.refit();
  }

  refit(): void {
    this.camera = fitted(this.camera, ...this.fitTo);
    this.draw();
  }

  zoom(factor: number): void {
    this.camera = zoomed(this.camera, factor, [this.camera.width / 2, this.camera.height / 2]);
    this.draw();
  }

  pan(dx_px: number, dy_px: number): void {
    this.camera = panned(this.camera, dx_px, dy_px);
    this.draw();
  }

  private drawNow(): void {
    this.due = false;
    const { x, y, m_per_px, width, height } = this.camera;
    Object.assign(this.view, {
      left: x - (width / 2) * m_per_px,
      right: x + (width / 2) * m_per_px,
      top: y + (height / 2) * m_per_px,
      bottom: y - (height / 2) * m_per_px,
    });
    this.view.updateProjectionMatrix();
    const scene = this.scene();
    this.picture.paint(scene, this.camera);
    this.renderer.render(this.world, this.view);
    this.label(scene);
    this.painted();
  }

  private label({ environment, selected }: Scene): void {
    const labels = axisLabels(this.camera);
    const things = thingLabels(this.camera, environment, selected);
    const shown = JSON.stringify([labels, things]);
    if (this.labels.dataset.shown === shown) return;
    this.labels.dataset.shown = shown;
    this.labels.replaceChildren(
      ...labels.map(({ axis, at, text }) => {
        const span = h('span', { class: axis }, text);
        span.style[axis === 'x' ? 'left' : 'top'] = `${at}px`;
        return span;
      }),
      ...things.map(({ at: [x, y], text }) => {
        const span = h('span', { class: 'thing' }, text);
        Object.assign(span.style, { left: `${x}px`, top: `${y}px` });
        return span;
      }),
    );
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement!;
    if (width === 0 || height === 0) return;
    const first = this.camera.width === 1;
    this.camera = { ...this.camera, width, height };
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    if (first) this.refit();
    this.drawNow();
  }

  private at(event: PointerEvent | WheelEvent): Point {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  private down(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, this.at(event));
    if (this.pointers.size > 1) {
      this.letGo(true);
      return;
    }
    const reach = (event.pointerType === 'touch' ? kFinger_px : kMouse_px) * this.camera.m_per_px;
    this.grabbed = this.events.down(toWorld(this.camera, this.at(event)), reach, event);
  }

  private move(event: PointerEvent): void {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = this.at(event);
    this.pointers.set(event.pointerId, now);
    if (this.pointers.size === 2) {
      this.pinch(event.pointerId, before, now);
    } else if (this.grabbed) {
      this.events.drag(toWorld(this.camera, now), event);
    } else {
      this.pan(now[0] - before[0], now[1] - before[1]);
    }
  }

  private pinch(id: number, before: Point, now: Point): void {
    const other = [...this.pointers].find(([key]) => key !== id)![1];
    const spread = (p: Point) => Math.hypot(p[0] - other[0], p[1] - other[1]);
    this.camera = panned(this.camera, (now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
    if (spread(before) > 0) this.camera = zoomed(this.camera, spread(now) / spread(before), other);
    this.draw();
  }

  private up(event: PointerEvent): void {
    this.pointers.delete(event.pointerId);
    this.letGo(event.type === 'pointercancel');
  }
  private letGo(isCut: boolean): void {
    const held = this.grabbed;
    this.grabbed = false;
    if (held) this.events.up(isCut);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    this.camera = zoomed(this.camera, Math.exp(-event.deltaY * 0.0015), this.at(event));
    this.draw();
  }
}
