import type { Point } from './environment';

/** Red, green, blue, opacity, from 0 to 1. */
export type Colour = [number, number, number, number];

export const faded = ([r, g, b, a]: Colour, share: number): Colour => [r, g, b, a * share];
export const mixed = (a: Colour, b: Colour, share: number): Colour =>
  a.map((v, i) => v + (b[i] - v) * share) as Colour;

/** A colour of the style sheet: `--name: #rrggbb`. */
export function cssColour(name: string): Colour {
  const text = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const bytes = [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16) / 255);
  return [...bytes, 1] as unknown as Colour;
}

/** What pictures are painted with, in metres. Later things lie on earlier ones. */
export interface Brush {
  begin(): void;
  end(): void;
  triangle(a: Point, b: Point, c: Point, colour: Colour): void;
  quad(a: Point, b: Point, c: Point, d: Point, colour: Colour): void;
  polygon(points: Point[], colour: Colour): void;
  line(a: Point, b: Point, width: number, colour: Colour): void;
  path(points: Point[], width: number, colour: Colour, closed?: boolean): void;
  disc(centre: Point, radius: number, colour: Colour): void;
  ring(centre: Point, radius: number, width: number, colour: Colour): void;
}

export function circle([x, y]: Point, radius: number, sides = 48): Point[] {
  return Array.from({ length: sides }, (_, i) => {
    const angle = (2 * Math.PI * i) / sides;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}
