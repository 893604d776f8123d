import type { Arm, Environment, Family, Motion, Obstacle, Polygon, TrackKey, Trait } from './api';
import { button, checkbox, facts, field, h, numberInput, tool } from './dom';
import { kindOf, type Point, type Selection, withCorner, withObstacle } from './environment';
import { trackNames } from './names';
import type { LivePlanner } from './planner';
import { valueOf, withValue } from './traits';

const seconds = (s: number): string => (s < 1 ? `${Math.round(s * 1000)} ms` : `${s.toFixed(1)} s`);
export const cm = (m: number): string => `${(m * 100).toFixed(2)} cm`;
const thousands = (n: number): string => Math.round(n).toLocaleString('en');

/** Numbers of what is selected, to type. */
export function selectionPanel(
  environment: Environment,
  selected: Selection,
  change: (environment: Environment) => void,
  remove: () => void,
): HTMLElement {
  if (selected === null) return h('p', { class: 'hint' }, 'Select the goal or an obstacle to edit its numbers.');
  const row = (values: Record<string, number>, set: (key: string, value: number) => void) =>
    Object.entries(values).map(([key, value]) => {
      const angle = key.endsWith('_rad');
      const names: Record<string, string> = {
        x_m: 'x', y_m: 'y', radius_m: 'Radius', width_m: 'Width', height_m: 'Height',
        angle_rad: 'Angle', theta_rad: 'Heading', position_tolerance_m: 'Tolerance',
        orientation_tolerance_rad: 'Heading tolerance',
      };
      return field(names[key] ?? key, numberInput(value, angle ? 0.05 : 0.005, (v) => set(key, v)), angle ? 'rad' : 'm');
    });
  if (selected === 'goal') {
    const { goal } = environment;
    const turn = checkbox('with a heading', goal.theta_rad !== undefined, (on) => {
      const { theta_rad: _t, orientation_tolerance_rad: _o, ...place } = goal;
      const heading = { theta_rad: 0, orientation_tolerance_rad: 0.3 };
      change({ ...environment, goal: on ? { ...place, ...heading } : place });
    });
    return h('div', { class: 'fields' },
      ...row(goal, (key, value) => change({ ...environment, goal: { ...goal, [key]: value } })), turn);
  }
  const obstacle = environment.obstacles[selected];
  const set = (next: Obstacle) => change(withObstacle(environment, selected, next));
  const fields =
    'polygon' in obstacle
      ? obstacle.polygon.flatMap(([x, y], i) =>
          row({ [`x ${i}`]: x, [`y ${i}`]: y }, (key, value) =>
            set({
              polygon: obstacle.polygon.map((p, k): Point =>
                k !== i ? p : key.startsWith('x') ? [value, p[1]] : [p[0], value]),
            })))
      : 'circle' in obstacle
        ? row(obstacle.circle, (key, value) => set({ circle: { ...obstacle.circle, [key]: value } }))
        : row(obstacle.rectangle, (key, value) => set({ rectangle: { ...obstacle.rectangle, [key]: value } }));
  return h('div', { class: 'fields' }, ...fields, 'polygon' in obstacle && cornerRow(obstacle, set), button('Delete', remove, { class: 'danger', id: 'delete' }));
}

/** Adds and removes corners: as many as there are, three at least. */
function cornerRow({ polygon }: Polygon, set: (next: Polygon) => void): HTMLElement {
  return h('div', { class: 'row' }, button('Add a corner', () => set({ polygon: withCorner(polygon) })),
    ...(polygon.length < 4 ? [] : polygon.map((_, i) =>
      tool(`− ${i}`, `Remove corner ${i}`, () => set({ polygon: polygon.filter((_corner, k) => k !== i) })))));
}

/** Everything in the environment, to select without a pointer. */
export function thingsList(environment: Environment, selected: Selection, select: (s: Selection) => void): HTMLElement {
  const entry = (name: string, what: Selection) =>
    h('li', {}, button(name, () => select(what), { 'aria-pressed': String(selected === what) }));
  return h('ul', { class: 'things' }, entry('Goal', 'goal'),
    ...environment.obstacles.map((obstacle, i) => entry(`${i} · ${kindOf(obstacle)}`, i)));
}

/** A model that can't plan before it is one arm's. @param step  of fitting it; empty: nobody does */
export function familyPanel(step: string, fit: () => void): HTMLElement {
  return h('div', { class: step ? 'status busy' : 'status' }, h('strong', {}, 'A family of arms'),
    h('p', {}, step || 'It plans once it knows which arm is yours: from a minute of its motion.'),
    button('Fit it to the virtual arm', fit, { class: 'main', disabled: step !== '' }),
    h('p', { class: 'hint' }, 'For a real arm, limber collect --schedule identify records the minute, and limber adapt fits it.'));
}

const kOfTheSimpleModel = "the no-load model's error is not known"; // said above in the page's own words

const kFlags = /: --(?:margin-m ([\d.e-]+)|goal-margin-m 0 keeps none)/g; // of limber plan, in reasons

/** Why there is no plan, and where one keeps less: a button that asks for it. */
function reasonParts(reason: string, keep: (margin_m: number) => void): HTMLElement[] {
  const margin_m = [...reason.matchAll(kFlags)].map(([, found]) => Number(found)).find(Number.isFinite);
  return [h('p', {}, reason.replaceAll(kFlags, '')),
    ...(margin_m === undefined ? [] : [button(`Keep ${cm(margin_m)}`, () => keep(margin_m), { class: 'main' })])];
}

/** What the search says. @param simple  whether the simple model plans @param keep  asks for less clearance */
export function planPanel(planner: LivePlanner, unit: string, simple: boolean, keep: (margin_m: number) => void): HTMLElement {
  const { plan, progress, result, fault, searching, isCurrent } = planner;
  if (fault) return h('div', { class: 'status bad' }, h('strong', {}, 'Not planned'), h('p', {}, fault));
  if (plan && isCurrent) {
    const queries = result?.queries ?? progress?.queries;
    const time_s = result?.time_s ?? progress?.time_s;
    return h('div', { class: simple ? 'status good unsure' : 'status good', 'data-cost': plan.cost_kpa.toFixed(3) },
      h('strong', {}, simple ? 'Certified, for the simple model alone' : 'Certified plan', searching && h('em', {}, ' improving …')),
      simple && h('p', { class: 'warning' }, 'The arm itself mostly misses such plans, and may collide. Choose a model that has learnt this arm.'),
      facts([
        ['Cost', `${plan.cost_kpa.toFixed(1)} ${unit}`],
        ['Duration', `${plan.duration_s.toFixed(1)} s`],
        ['Clearance', plan.clearance_m === null ? 'no obstacles' : cm(plan.clearance_m)],
        ['Ends from the goal’s centre', cm(plan.goal_distance_m)],
        ...(plan.first_s === undefined ? [] : ([['First certified after', seconds(plan.first_s)]] as [string, string][])),
        ...(queries && time_s
          ? ([
              ['Model queries', thousands(queries)],
              ['Queries per second', thousands(queries / time_s)],
            ] as [string, string][])
          : []),
      ]),
      ...(plan.warnings ?? result?.warnings ?? []).filter((text) => !text.startsWith(kOfTheSimpleModel)).map((text) => h('p', { class: 'warning' }, text)));
  }
  if (searching) {
    return h('div', { class: 'status busy' }, h('strong', {}, 'Searching …'),
      progress && facts([['Nodes', thousands(progress.nodes)], ['Time', seconds(progress.time_s)]]),
      progress?.doubt ? h('p', {}, progress.doubt) : null);
  }
  if (result) {
    const titles: Record<string, string> = {
      limit: 'No plan found',
      invalid_start: 'The start is not free',
      goal_unreachable: 'The goal is out of reach',
      goal_in_collision: 'The goal is not free',
      not_certified: 'No plan is certified',
    };
    return h('div', { class: 'status bad' }, h('strong', {}, titles[result.status] ?? result.status), ...reasonParts(result.reason, keep));
  }
  return h('div', { class: 'status' }, h('strong', {}, 'Not planned yet'));
}

/** Shares of the arm's pressure limits, up to the one that the studio was started with; and the chosen one. */
export function scaleChoice(label: string, chosen: number, change: (scale: number) => void, highest = 1): HTMLSelectElement {
  const scales = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9].filter((scale) => scale < highest);
  const offered = [...new Set([...scales, highest, chosen])].sort((a, b) => a - b);
  const select = h('select', { 'aria-label': label },
    ...offered.map((scale) =>
      h('option', { value: scale, selected: scale === chosen }, `${Math.round(100 * scale)} %`)));
  select.addEventListener('change', () => change(Number(select.value)));
  return select;
}

/** The share of its limits that a plan needs. */
export function neededScale(arm: Arm, setpoints_kpa: number[][]): number {
  const share = (kpa: number, { lower_kpa, upper_kpa }: Arm['segments'][number]): number =>
    kpa === 0 ? 0 : kpa / (kpa > 0 ? upper_kpa : lower_kpa);
  return Math.max(0, ...setpoints_kpa.flatMap((row) => row.map((kpa, i) => share(kpa, arm.segments[i]))));
}

/** One track's line: whether it is among those shown, and how it ended. */
export function tracksPanel(run: Motion, shown: Set<TrackKey>, changed: () => void): HTMLElement {
  const toggle = (key: TrackKey) => (on: boolean) => {
    if (on) shown.add(key);
    else shown.delete(key);
    changed();
  };
  return h('ul', { class: 'tracks' },
    ...run.tracks.map(({ key, outcome }) =>
      h('li', {}, h('i', { class: `swatch ${key}` }), checkbox(trackNames[key], shown.has(key), toggle(key)),
        h('small', {}, outcome))));
}

/** A slider with its name and value; arrow keys move it by a hundredth of its range. */
function sliderRow(
  name: string, label: string, [low, high]: [number, number], value: number,
  text: (value: number) => string, set: (value: number) => void,
): HTMLElement {
  const output = h('output', { 'aria-live': 'off' }, text(value)); // the slider says it
  const input = h('input', { type: 'range', min: low, max: high, step: 'any', value: String(value), 'aria-label': label });
  input.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    input.valueAsNumber += (step * (high - low)) / 100;
    input.dispatchEvent(new Event('input'));
  });
  input.addEventListener('input', () => {
    output.textContent = text(input.valueAsNumber);
    set(input.valueAsNumber);
  });
  return h('label', {}, h('span', {}, name), input, output);
}

/** A slider for each segment's pressure. */
export function driveSliders(arm: Arm, setpoint_kpa: number[], set: (i: number, kpa: number) => void): HTMLElement {
  const { unit, name } = arm.command;
  return h('div', { class: 'sliders' },
    ...arm.segments.map(({ lower_kpa, upper_kpa }, i) =>
      sliderRow(`Segment ${i}`, `Segment ${i}, ${name} in ${unit}`, [lower_kpa, upper_kpa], setpoint_kpa[i],
        (kpa) => `${kpa.toFixed(0)} ${unit}`, (kpa) => set(i, kpa))));
}

const kShownNumbers = 6; // of a family
const kFarthest = 2; // standard deviations of its arms

/** A slider for each number that tells the family's arms apart. */
function numberRows(e: number[], count: number, become: (e: number[]) => void): HTMLElement[] {
  let now = e;
  return e.slice(0, count).map((value, i) =>
    sliderRow(`e ${i}`, `Number ${i} of the family, in standard deviations`,
      [Math.min(-kFarthest, value), Math.max(kFarthest, value)], value, (v) => v.toFixed(2), (v) => {
        now = now.map((old, k) => (k === i ? v : old));
        become(now);
      }));
}

/** A slider for each quantity that those numbers tell of; each leaves the others where they are. */
function traitRows(traits: Trait[], e: number[], become: (e: number[]) => void): HTMLElement[] {
  let now = e;
  return traits.map((trait) => {
    const { text, unit, low, high } = trait;
    const value = valueOf(trait, e);
    const decimals = Math.max(0, Math.min(4, 2 - Math.floor(Math.log10(high - low))));
    return sliderRow(text, `${text}, of the arm file ${trait.of_arm_file.toFixed(decimals)}${unit}`,
      [Math.min(low, value), Math.max(high, value)], value, (v) => v.toFixed(decimals) + unit, (v) => {
        now = withValue(trait, now, v);
        become(now);
      });
  });
}

/** Which arm of the family: by its physics where the family knows that, else by its first numbers. */
export function familySliders(
  { traits }: Family, e: number[], all: boolean, become: (e: number[]) => void, more: () => void,
): HTMLElement {
  const shown = traits.length > 0 ? 0 : Math.min(e.length, kShownNumbers);
  return h('div', { class: 'sliders', id: 'family' },
    ...(shown > 0 || all ? numberRows(e, all ? e.length : shown, become) : traitRows(traits, e, become)),
    e.length > shown && button(
      !all ? `${shown > 0 ? 'More' : 'The numbers behind it'}: ${e.length - shown}` : shown > 0 ? 'Fewer' : 'What they tell of',
      more, { 'aria-expanded': String(all) }));
}
