// A scene as an address's fragment: names of arm, model and environment, and what was edited by
// hand. A fragment never reaches a server, and the token is no part of it. Whoever opens a link did
// not write it, so what it holds is checked before anything is drawn.

import { type Environment, type Goal, type Obstacle, type Project, Refusal } from './api';

export type SceneLink = {
  arm: string;
  model: string;
  environmentName: string;
  environment: Environment | null; // null: as it is stored under its name
};

const kMostCharacters = 100_000; // no scene by hand needs a tenth; browsers take two millions

/** In base 64 with the signs that addresses leave alone. */
function packedText(text: string): string {
  const bytes = new TextEncoder().encode(text);
  const signs = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  return signs.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}
function unpackedText(packed: string): string {
  const signs = atob(packed.replaceAll('-', '+').replaceAll('_', '/'));
  const bytes = Uint8Array.from(signs, (sign) => sign.charCodeAt(0));
  return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
}

type Fields = Record<string, unknown>;
const isFields = (value: unknown): value is Fields =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
/** Numbers under these keys, and nothing else. */
function hasNumbers(value: unknown, keys: string[], optional: string[] = []): value is Fields {
  return isFields(value) && keys.every((key) => key in value) && Object.entries(value).every(
    ([key, number]) => [...keys, ...optional].includes(key) && Number.isFinite(number));
}
const areRows = (value: unknown, columns?: number): boolean =>
  Array.isArray(value) && value.every((row) => Array.isArray(row) && row.every(Number.isFinite) &&
    (columns === undefined || row.length === columns));

function isObstacle(value: unknown): value is Obstacle {
  if (!isFields(value) || Object.keys(value).length !== 1) return false;
  const { circle, rectangle, polygon } = value;
  return hasNumbers(circle, ['x_m', 'y_m', 'radius_m']) ||
    hasNumbers(rectangle, ['x_m', 'y_m', 'width_m', 'height_m', 'angle_rad']) ||
    (areRows(polygon, 2) && (polygon as unknown[]).length > 2);
}
function isGoal(value: unknown): value is Goal {
  const heading = ['theta_rad', 'orientation_tolerance_rad'];
  return hasNumbers(value, ['x_m', 'y_m', 'position_tolerance_m'], heading);
}
/** "rest", or a posture; whether it is the arm's, the server says. */
function isStart(value: unknown): boolean {
  return value === 'rest' || (isFields(value) && areRows(value.backbone, 3));
}

function environmentOf(packed: string): Environment | null {
  if (packed.length > kMostCharacters) return null;
  try {
    const value: unknown = JSON.parse(unpackedText(packed));
    if (!isFields(value)) return null;
    const { name, obstacles, start, goal } = value;
    if (typeof name !== 'string' || !Array.isArray(obstacles)) return null;
    if (!obstacles.every(isObstacle) || !isStart(start) || !isGoal(goal)) return null;
    return { name, obstacles, start, goal };
  } catch {
    return null;
  }
}

export function fragmentOf({ arm, model, environmentName, environment }: SceneLink): string {
  const names = new URLSearchParams({ arm, model, environment: environmentName });
  if (environment) names.set('scene', packedText(JSON.stringify(environment)));
  return `#${names}`;
}

/**
 * What a fragment names; what it leaves out is the project's first.
 * @throws Refusal  if its scene can't be read, or the project has no such arm, model or environment
 */
export function linkOf(fragment: string, project: Project): SceneLink {
  const { arms, models, environments, first_arm, first_model } = project;
  const at = new URLSearchParams(fragment.replace(/^#/, ''));
  const packed = at.get('scene');
  const environment = packed === null ? null : environmentOf(packed);
  if (packed !== null && environment === null) {
    throw new Refusal(0, 'The link’s scene can’t be read. Was the link cut off?');
  }
  const named = (key: string, names: string[], first: string, isNeeded = true): string => {
    const name = at.get(key) ?? first;
    if (names.includes(name) || name === first) return name;
    if (isNeeded) throw new Refusal(0, `The link’s ${key} '${name}' is not in this project.`);
    return first;
  };
  const first = environments.find((name) => name.endsWith('01_pillar')) ?? environments[0];
  return {
    arm: named('arm', arms, first_arm),
    model: named('model', ['', ...models], first_model),
    environmentName: named('environment', environments, first, environment === null),
    environment,
  };
}
