import * as THREE from 'three';
import { type Brush, circle, type Colour } from './brush';
import type { Point } from './environment';

/**
 * Collects triangles in the order in which they are painted, all in one mesh and one draw call.
 * A whole picture is rebuilt in a millisecond or two, so nothing has to be kept up to date.
 */
export class Painter implements Brush {
  private positions = new Float32Array(3 * 4096);
  private colours = new Float32Array(4 * 4096);
  private count = 0;
  private readonly geometry = new THREE.BufferGeometry();
  readonly mesh: THREE.Mesh;

  constructor() {
    const material = new THREE.MeshBasicMaterial({
      vertexColors: true,
      transparent: true,
      depthTest: false,
      side: THREE.DoubleSide,
      forceSinglePass: true, // else all triangles that turn clockwise come first
    });
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
    this.attach();
  }

  begin(): void {
    this.count = 0;
  }

  /** Shows what was painted since `begin`. */
  end(): void {
    for (const name of ['position', 'color']) {
      this.geometry.getAttribute(name).needsUpdate = true;
    }
    this.geometry.setDrawRange(0, this.count);
  }

  triangle(a: Point, b: Point, c: Point, colour: Colour): void {
    if (3 * (this.count + 3) > this.positions.length) this.grow();
    for (const [x, y] of [a, b, c]) {
      this.positions[3 * this.count] = x;
      this.positions[3 * this.count + 1] = y;
      this.colours.set(colour, 4 * this.count);
      ++this.count;
    }
  }

  quad(a: Point, b: Point, c: Point, d: Point, colour: Colour): void {
    this.triangle(a, b, c, colour);
    this.triangle(a, c, d, colour);
  }

  /** A simple polygon, convex or not. */
  polygon(points: Point[], colour: Colour): void {
    const corners = points.map(([x, y]) => new THREE.Vector2(x, y));
    for (const [a, b, c] of THREE.ShapeUtils.triangulateShape(corners, [])) {
      this.triangle(points[a], points[b], points[c], colour);
    }
  }

  line(a: Point, b: Point, width: number, colour: Colour): void {
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length === 0) return;
    const nx = ((a[1] - b[1]) / length) * (width / 2);
    const ny = ((b[0] - a[0]) / length) * (width / 2);
    this.quad(
      [a[0] + nx, a[1] + ny],
      [b[0] + nx, b[1] + ny],
      [b[0] - nx, b[1] - ny],
      [a[0] - nx, a[1] - ny],
      colour,
    );
  }

  /** Joined at its corners, so that it is of one opacity throughout. */
  path(points: Point[], width: number, colour: Colour, closed = false): void {
    const n = points.length;
    if (n < 2) return;
    const side = (i: number): [Point, Point] => {
      const before = points[closed ? (i + n - 1) % n : Math.max(0, i - 1)];
      const after = points[closed ? (i + 1) % n : Math.min(n - 1, i + 1)];
      const [x, y] = points[i];
      const first = Math.atan2(y - before[1], x - before[0]);
      const second = Math.atan2(after[1] - y, after[0] - x);
      const into = before === points[i] ? second : first;
      const out = after === points[i] ? first : second;
      const bend = Math.atan2(Math.sin(out - into), Math.cos(out - into)) / 2;
      const reach = width / 2 / Math.max(0.3, Math.cos(bend));
      const normal = into + bend + Math.PI / 2;
      const dx = reach * Math.cos(normal);
      const dy = reach * Math.sin(normal);
      return [[x + dx, y + dy], [x - dx, y - dy]];
    };
    let last = side(0);
    for (let i = 1; i < n + (closed ? 1 : 0); ++i) {
      const next = side(i % n);
      this.quad(last[0], next[0], next[1], last[1], colour);
      last = next;
    }
  }

  disc([x, y]: Point, radius: number, colour: Colour): void {
    const rim = circle([x, y], radius);
    rim.forEach((point, i) => this.triangle([x, y], point, rim[(i + 1) % rim.length], colour));
  }

  ring(centre: Point, radius: number, width: number, colour: Colour): void {
    this.path(circle(centre, radius), width, colour, true);
  }

  private attach(): void {
    this.geometry.setAttribute('position', new THREE.BufferAttribute(this.positions, 3));
    this.geometry.setAttribute('color', new THREE.BufferAttribute(this.colours, 4));
  }

  private grow(): void {
    const double = (old: Float32Array): Float32Array<ArrayBuffer> => {
      const larger = new Float32Array(2 * old.length);
      larger.set(old);
      return larger;
    };
    this.positions = double(this.positions);
    this.colours = double(this.colours);
    this.geometry.dispose();
    this.attach();
  }
}
