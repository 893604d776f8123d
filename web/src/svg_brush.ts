import type { Brush, Colour } from './brush';
import { type Camera, toPixels } from './camera';
import type { Point } from './environment';

/** Paints scalable drawings, as text. */
export class SvgBrush implements Brush {
  private parts: string[] = [];

  constructor(private readonly camera: Camera) {}

  begin(): void {
    this.parts = [];
  }
  end(): void {}
  /** What was painted since `begin`: the inside of an svg element of the camera's size. */
  get text(): string {
    return this.parts.join('');
  }

  triangle(a: Point, b: Point, c: Point, colour: Colour): void {
    this.polygon([a, b, c], colour);
  }
  quad(a: Point, b: Point, c: Point, d: Point, colour: Colour): void {
    this.polygon([a, b, c, d], colour);
  }
  polygon(points: Point[], colour: Colour): void {
    this.add(`path d="${this.along(points)}Z"`, 'fill', colour);
  }
  line(a: Point, b: Point, width: number, colour: Colour): void {
    this.path([a, b], width, colour);
  }
  path(points: Point[], width: number, colour: Colour, closed = false): void {
    if (points.length < 2) return;
    const shape = `path fill="none" stroke-linejoin="round" stroke-width="${this.px(width)}" d="${this.along(points)}${closed ? 'Z' : ''}"`;
    this.add(shape, 'stroke', colour);
  }
  disc(centre: Point, radius: number, colour: Colour): void {
    this.add(this.circle(centre, radius), 'fill', colour);
  }
  ring(centre: Point, radius: number, width: number, colour: Colour): void {
    this.add(`${this.circle(centre, radius)} fill="none" stroke-width="${this.px(width)}"`, 'stroke', colour);
  }

  private circle(centre: Point, radius: number): string {
    const [x, y] = toPixels(this.camera, centre);
    return `circle cx="${x.toFixed(2)}" cy="${y.toFixed(2)}" r="${this.px(radius)}"`;
  }
  private px(metres: number): string {
    return (metres / this.camera.m_per_px).toFixed(2);
  }
  private along(points: Point[]): string {
    return points.map((point, i) => `${i === 0 ? 'M' : 'L'}${toPixels(this.camera, point).map((v) => v.toFixed(2)).join(' ')}`).join('');
  }
  private add(shape: string, kind: 'fill' | 'stroke', [r, g, b, a]: Colour): void {
    const rgb = [r, g, b].map((v) => Math.round(255 * v)).join(',');
    this.parts.push(`<${shape} ${kind}="rgb(${rgb})"${a < 1 ? ` ${kind}-opacity="${a.toFixed(3)}"` : ''}/>`);
  }
}
