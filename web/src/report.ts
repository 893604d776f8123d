// Charts of a report, hovered and zoomed. They are plain SVG; an area that lines are drawn in says which data its edges
// stand for (data-x, data-y), a line what it is called (data-name). A drag zooms, a double click shows everything again.

type Point = [x: number, y: number];

const kNear_px = 4; // a shorter drag is none
const kShown = 5; // digits of a number
const kApart_px = 20; // a line's next point may be so far from the pointer: else there is none
const kInk = '#1d2328'; // of the chart's own text, src/plot
const kSoft = '#58636d';
const kTick_px = { size: 14, below: 20 };

const shown = (value: number): string => String(Number(value.toPrecision(kShown)));
const create = (tag: string, attributes: Record<string, string | number>): SVGElement => {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
};

/** Numbers for an axis: a round step, four to eight of them. */
export function ticksOf(low: number, high: number): number[] {
  const raw = (high - low) / 8;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw * (1 - 1e-9))!;
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.floor(high / step + 1e-9) - first + 1 }, (_, k) => Number(((first + k) * step).toPrecision(12)));
}

/** What a share of an axis stands for. @param text  "low high", or "low high log" */
export function valueAt(text: string, share: number): number {
  const [low, high] = text.split(' ').map(Number);
  return text.endsWith('log') ? low * (high / low) ** share : low + share * (high - low);
}

/** Corners of a path of M and L commands. */
export const pointsOf = (path: string): Point[] =>
  [...path.matchAll(/([-\d.e]+)[ ,]([-\d.e]+)/g)].map(([, x, y]) => [Number(x), Number(y)]);

class Area {
  private readonly width: number;
  private readonly height: number;
  private readonly lines: { name: string; color: string; points: Point[] }[];
  private readonly cursor: SVGElement;
  private readonly chosen: SVGElement;
  private readonly ticks: Element | null;
  private readonly allTicks: Node[];
  private seen: [number, number]; // left and right edge, in pixels of the whole
  private from: number | null = null;

  constructor(private readonly svg: SVGSVGElement, private readonly note: HTMLElement) {
    [this.width, this.height] = ['width', 'height'].map((name) => Number(svg.getAttribute(name)));
    this.seen = [0, this.width];
    this.lines = [...svg.querySelectorAll('path[data-name]')].map((path) => ({
      name: path.getAttribute('data-name')!, color: path.getAttribute('stroke')!, points: pointsOf(path.getAttribute('d')!),
    }));
    for (const path of svg.querySelectorAll('path')) path.setAttribute('vector-effect', 'non-scaling-stroke');
    this.ticks = svg.parentElement!.querySelector('[data-ticks="x"]');
    this.allTicks = [...(this.ticks?.childNodes ?? [])];
    this.cursor = create('path', { stroke: kSoft, fill: 'none', 'vector-effect': 'non-scaling-stroke' });
    this.chosen = create('rect', { y: 0, height: this.height, width: 0, fill: kSoft, opacity: 0.15 });
    // A rectangle under everything, so that the pointer is seen between lines too.
    svg.prepend(create('rect', { width: this.width, height: this.height, fill: 'transparent' }));
    svg.append(this.chosen, this.cursor);
    svg.addEventListener('pointermove', (event) => this.hover(event));
    svg.addEventListener('pointerleave', () => this.leave());
    svg.addEventListener('pointerdown', (event) => { this.from = this.at(event); });
    svg.addEventListener('pointerup', (event) => this.choose(event));
    svg.addEventListener('dblclick', () => this.look(0, this.width));
  }

  private at(event: PointerEvent): number {
    const { x } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM()!.inverse());
    const [left, right] = this.seen;
    return Math.min(right, Math.max(left, x));
  }
  private x(at: number): number {
    return valueAt(this.svg.getAttribute('data-x')!, at / this.width);
  }
  private hover(event: PointerEvent): void {
    const at = this.at(event);
    if (this.from !== null && event.buttons > 0) {
      this.chosen.setAttribute('x', String(Math.min(at, this.from)));
      this.chosen.setAttribute('width', String(Math.abs(at - this.from)));
    }
    this.cursor.setAttribute('d', `M${at} 0V${this.height}`);
    const rows = this.lines.map(({ name, color, points }) => {
      const [x, y] = points.reduce((best, point) => (Math.abs(point[0] - at) < Math.abs(best[0] - at) ? point : best));
      const near = Math.abs(x - at) * (this.width / (this.seen[1] - this.seen[0])) < kApart_px;
      return { name, color, value: near ? shown(valueAt(this.svg.getAttribute('data-y')!, 1 - y / this.height)) : '–' };
    });
    this.note.replaceChildren(shown(this.x(at)), ...rows.map(({ name, color, value }) => {
      const row = document.createElement('div');
      const key = document.createElement('i');
      key.style.background = color;
      row.append(key, ` ${name}: ${value}`);
      return row;
    }));
    this.note.hidden = false;
    this.note.style.left = `${Math.min(event.clientX + 14, innerWidth - this.note.offsetWidth - 8)}px`;
    this.note.style.top = `${Math.min(event.clientY + 14, innerHeight - this.note.offsetHeight - 8)}px`;
  }
  private leave(): void {
    this.note.hidden = true;
    this.from = null;
    this.cursor.removeAttribute('d');
    this.chosen.setAttribute('width', '0');
  }
  private choose(event: PointerEvent): void {
    const [from, to] = [this.from ?? 0, this.at(event)];
    this.chosen.setAttribute('width', '0');
    if (this.from !== null && Math.abs(to - from) > kNear_px) this.look(Math.min(from, to), Math.max(from, to));
    this.from = null;
  }
  private look(left: number, right: number): void {
    const isWhole = left === 0 && right === this.width;
    this.seen = [left, right];
    if (isWhole) this.svg.removeAttribute('viewBox');
    else this.svg.setAttribute('viewBox', `${left} 0 ${right - left} ${this.height}`);
    this.svg.setAttribute('preserveAspectRatio', 'none');
    this.ticks?.replaceChildren(...(isWhole ? this.allTicks : ticksOf(this.x(left), this.x(right)).map((value) => {
      const at = ((value - this.x(left)) / (this.x(right) - this.x(left))) * this.width;
      const text = create('text', { x: at, y: this.height + kTick_px.below, 'font-size': kTick_px.size, fill: kInk, 'text-anchor': 'middle' });
      text.textContent = String(value);
      return text;
    })));
  }
}

if (typeof document !== 'undefined') {
  const note = document.createElement('div');
  note.id = 'moment';
  note.hidden = true;
  document.body.append(note);
  for (const svg of document.querySelectorAll<SVGSVGElement>('svg[data-x]')) new Area(svg, note);
}
