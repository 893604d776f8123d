import type { Arm, Environment, Plan, TrackKey } from './api';
import { type Brush, type Colour, cssColour, faded, mixed } from './brush';
import { type Camera, gridStep_m, toWorld } from './camera';
import { handlesOf, outlineOf, type Point, type Selection } from './environment';
import { centreline, plate, plateCount, type Pose, sampled, segmentOfGap, tipOf, tubeRadii } from './shape';

/** One arm as it stands, and its pressures where its sides are to be coloured. */
export type Figure = {
  shape: number[];
  pressures_kpa?: number[];
  colour: keyof Palette;
  trail?: Point[];
  outlined?: boolean;
};

/** All that is shown. */
export type Scene = {
  arm: Arm | null;
  environment: Environment | null;
  selected: Selection;
  plan: Plan | null;
  stale: boolean; // the plan is of another problem than what is shown
  showTree: number[] | null;
  showTube: boolean;
  showReach: boolean;
  figures: Figure[];
  path?: Point[]; // that the tip is to follow
  hidesGoal?: boolean;
};

export type Palette = Record<
  TrackKey | 'ground' | 'grid' | 'axis' | 'reach' | 'obstacle' | 'goal' | 'body' | 'plate' |
    'pressure' | 'plan' | 'tree' | 'select',
  Colour
>;

export function readPalette(): Palette {
  const names: (keyof Palette)[] = [
    'simple', 'network', 'virtual_arm', 'arm', 'ground', 'grid', 'axis', 'reach', 'obstacle', 'goal',
    'body', 'plate', 'pressure', 'plan', 'tree', 'select',
  ];
  return Object.fromEntries(names.map((name) => [name, cssColour(`--${name}`)])) as Palette;
}

const kGhosts = 9; // shapes of a plan, from its start to its end

/** So far to the left of a pose, or to its right. */
const beside = ({ x, y, theta }: Pose, out_m: number): Point => [x - out_m * Math.sin(theta), y + out_m * Math.cos(theta)];

/** Paints scenes. Widths given in pixels stay what they are at any zoom. */
export class Picture {
  private palette = readPalette();

  constructor(
    private readonly painter: Brush,
    private camera: Camera,
  ) {}

  paint(scene: Scene, camera: Camera): void {
    this.camera = camera;
    this.painter.begin();
    if (scene.showReach && scene.arm) this.reach(scene.arm);
    this.grid();
    if (scene.showTree) this.tree(scene.showTree);
    if (scene.environment) this.environment(scene.environment, scene.selected, scene.hidesGoal);
    if (scene.path) this.painter.path(scene.path, this.px(2.5), this.palette.goal);
    if (scene.plan && scene.arm) this.plan(scene.plan, scene.arm, scene);
    for (const figure of scene.figures) {
      if (scene.arm) this.figure(figure, scene.arm);
    }
    if (scene.environment) this.handles(scene.environment, scene.selected);
    this.painter.end();
  }

  recolour(): void {
    this.palette = readPalette();
  }

  private px(pixels: number): number {
    return pixels * this.camera.m_per_px;
  }

  private reach({ reach: { cell_m, middles_m } }: Arm): void {
    const h = cell_m / 2;
    for (let i = 0, next; i < middles_m.length; i = next) {
      const [x, y] = [middles_m[i], middles_m[i + 1]];
      // Cells come column by column: those on top of one another are one.
      for (next = i + 2; middles_m[next] === x && middles_m[next + 1] - middles_m[next - 1] < 1.5 * cell_m; ) next += 2;
      const top = middles_m[next - 1];
      this.painter.quad([x - h, y - h], [x + h, y - h], [x + h, top + h], [x - h, top + h], this.palette.reach);
    }
  }

  private grid(): void {
    const { camera: c, painter } = this;
    const step = gridStep_m(c);
    const [left, top] = toWorld(c, [0, 0]);
    const [right, bottom] = toWorld(c, [c.width, c.height]);
    const colour = (k: number) => (k === 0 ? this.palette.axis : this.palette.grid);
    for (let k = Math.ceil(left / step); k * step <= right; ++k) {
      painter.line([k * step, bottom], [k * step, top], this.px(1), colour(k));
    }
    for (let k = Math.ceil(bottom / step); k * step <= top; ++k) {
      painter.line([left, k * step], [right, k * step], this.px(1), colour(k));
    }
  }

  private tree(edges: number[]): void {
    const colour = faded(this.palette.tree, 0.45);
    for (let i = 0; i + 3 < edges.length; i += 4) {
      this.painter.line([edges[i], edges[i + 1]], [edges[i + 2], edges[i + 3]], this.px(1), colour);
    }
  }

  private environment({ obstacles, goal }: Environment, selected: Selection, hidesGoal = false): void {
    const { painter, palette } = this;
    obstacles.forEach((obstacle, i) => {
      const outline = outlineOf(obstacle);
      painter.polygon(outline, faded(palette.obstacle, 0.55));
      const chosen = selected === i;
      painter.path(outline, this.px(chosen ? 2.5 : 1.5), chosen ? palette.select : palette.obstacle, true);
    });
    if (hidesGoal) return;
    const at: Point = [goal.x_m, goal.y_m];
    const chosen = selected === 'goal';
    painter.disc(at, goal.position_tolerance_m, faded(palette.goal, 0.22));
    painter.ring(at, goal.position_tolerance_m, this.px(chosen ? 2.5 : 1.5), chosen ? palette.select : palette.goal);
    painter.disc(at, this.px(2.5), palette.goal);
    if (goal.theta_rad !== undefined) {
      const reach = goal.position_tolerance_m + this.px(14);
      const tip: Point = [at[0] + reach * Math.cos(goal.theta_rad), at[1] + reach * Math.sin(goal.theta_rad)];
      painter.line(at, tip, this.px(2), palette.goal);
      const wing = (turn: number): Point => [
        tip[0] + this.px(8) * Math.cos(goal.theta_rad! + turn),
        tip[1] + this.px(8) * Math.sin(goal.theta_rad! + turn),
      ];
      painter.triangle(tip, wing(2.7), wing(-2.7), palette.goal);
    }
  }

  private handles(environment: Environment, selected: Selection): void {
    for (const [, point] of handlesOf(environment, selected)) {
      this.painter.disc(point, this.px(6.5), this.palette.select);
      this.painter.disc(point, this.px(4.5), this.palette.ground);
    }
  }

  private plan(plan: Plan, arm: Arm, scene: Scene): void {
    const { painter, palette } = this;
    const strength = scene.stale ? 0.35 : 1;
    const gaps = segmentOfGap(arm);
    const ghosts = sampled(plan.shapes, kGhosts);
    if (scene.showTube && plan.tube) {
      for (const shape of ghosts) {
        const radii = tubeRadii(plan.tube, plan.shapes[0], shape);
        const points = Array.from({ length: plateCount(shape) }, (_, i) => plate(shape, i));
        const side = (sign: number): Point[] =>
          points.map((pose, i) => {
            const half = arm.segments[gaps[Math.max(0, i - 1)]].width_m / 2;
            return beside(pose, sign * (half + arm.actuator_radius_m + radii[i]));
          });
        const [left, right] = [side(1), side(-1)];
        for (let i = 0; i + 1 < points.length; ++i) {
          painter.quad(left[i], left[i + 1], right[i + 1], right[i], faded(palette.plan, 0.05 * strength));
        }
      }
    }
    ghosts.forEach((shape, k) => {
      const late = (k + 1) / ghosts.length;
      const line = centreline(shape).map(({ x, y }): Point => [x, y]);
      painter.path(line, this.px(2), faded(palette.plan, (0.12 + 0.5 * late * late) * strength));
    });
    painter.path(plan.shapes.map(tipOf), this.px(2.5), faded(palette.plan, 0.9 * strength));
    painter.disc(tipOf(plan.shapes[plan.shapes.length - 1]), this.px(4), faded(palette.plan, strength));
  }

  /** The arm to scale: a half for each side, coloured by its pressure, and the plates between. */
  private figure(figure: Figure, arm: Arm): void {
    const { painter, palette } = this;
    const colour = palette[figure.colour];
    if (figure.trail) painter.path(figure.trail, this.px(1.75), faded(colour, 0.8));
    const gaps = segmentOfGap(arm);
    const stations = centreline(figure.shape);
    const edge = (i: number, sign: number): Point =>
      beside(stations[i], (sign * arm.segments[gaps[stations[i].gap]].width_m) / 2);
    const middle = (i: number): Point => [stations[i].x, stations[i].y];
    if (!figure.outlined) {
      for (let i = 0; i + 1 < stations.length; ++i) {
        if (stations[i].gap !== stations[i + 1].gap) continue;
        const kpa = figure.pressures_kpa?.[gaps[stations[i].gap]] ?? 0;
        const { lower_kpa, upper_kpa } = arm.segments[gaps[stations[i].gap]];
        for (const sign of [1, -1]) {
          // A positive pressure is the right side's.
          const share = sign < 0 ? kpa / Math.max(upper_kpa, 1e-9) : kpa / Math.min(lower_kpa, -1e-9);
          const side = mixed(palette.body, palette.pressure, Math.max(0, Math.min(1, share)));
          painter.quad(edge(i, sign), edge(i + 1, sign), middle(i + 1), middle(i), faded(side, 0.92));
        }
      }
    }
    for (const sign of [1, -1]) {
      painter.path(stations.map((_, i) => edge(i, sign)), this.px(1.5), colour);
    }
    for (let i = 0; i < plateCount(figure.shape); ++i) {
      const pose = plate(figure.shape, i);
      const half = arm.segments[gaps[Math.max(0, i - 1)]].width_m / 2;
      const boundary = i === 0 || gaps[i - 1] !== gaps[i];
      painter.line(beside(pose, half), beside(pose, -half), this.px(boundary ? 3 : 1.25),
        figure.outlined ? colour : palette.plate);
    }
    painter.disc(tipOf(figure.shape), this.px(3.5), colour);
  }
}
