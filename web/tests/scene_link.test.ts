import { describe, expect, it } from 'vitest';
import type { Environment, Project } from '../src/api';
import { fragmentOf, linkOf } from '../src/scene_link';

const project: Project = {
  version: '1', folder: '/p', arms: ['limber:three_segment', 'mine'], models: ['model.safetensors'],
  environments: ['limber:01_pillar', 'limber:02_two_pillars'], families: [], recordings: [], plans: [], first_arm: 'limber:three_segment',
  first_model: 'model.safetensors', driver: '', driver_arm: '', driver_limit_scale: 1,
};
const environment: Environment = {
  name: 'Größe + 100 % = "äöü" / \u{1F4CF}',
  obstacles: [
    { circle: { x_m: 0.3, y_m: 0.1, radius_m: 0.05 } },
    { rectangle: { x_m: 0.5, y_m: -0.2, width_m: 0.2, height_m: 0.1, angle_rad: 1.57 } },
    { polygon: [[0, 0.3], [0.1, 0.3], [0.1, 0.4]] },
  ],
  start: { pressures_kpa: [0, 1, 2], backbone: [[0, 0, 0], [0.1, 0.01, 0.2]] },
  goal: {
    x_m: 0.4, y_m: 0.3, theta_rad: 0.5, position_tolerance_m: 0.02, orientation_tolerance_rad: 0.3,
  },
};
const link = { arm: 'mine', model: '', environmentName: 'limber:02_two_pillars', environment };
const linkTo = (scene: unknown): string =>
  fragmentOf({ ...link, environment: scene as Environment });
const kUnreadable = 'The link’s scene can’t be read. Was the link cut off?';

describe('a link', () => {
  it('restores arm, model, environment and goal to the bit', () => {
    expect(linkOf(fragmentOf(link), project)).toEqual(link);
    const stored = { ...link, environment: null };
    expect(linkOf(fragmentOf(stored), project)).toEqual(stored);
  });
  it('has only signs that mails and chats leave alone', () => {
    expect(fragmentOf(link)).toMatch(/^#[\w\-.~%&=+]+$/);
  });
  it('leaves to the project what it does not name', () => {
    expect(linkOf('', project)).toEqual({
      arm: 'limber:three_segment', model: 'model.safetensors',
      environmentName: 'limber:01_pillar', environment: null,
    });
  });
  it('restores a scene whose environment the project has not stored', () => {
    const there = linkOf(fragmentOf({ ...link, environmentName: 'theirs' }), project);
    expect(there).toEqual({ ...link, environmentName: 'limber:01_pillar' });
  });
  it('says what the project does not have', () => {
    for (const key of ['arm', 'model', 'environment']) {
      const words = `The link’s ${key} 'theirs' is not in this project.`;
      expect(() => linkOf(`#${key}=theirs`, project)).toThrow(words);
    }
  });
});

describe('a scene that is not one', () => {
  it('is refused wherever the link was cut off', () => {
    const whole = fragmentOf(link);
    const begin = whole.indexOf('scene=') + 'scene='.length;
    for (let end = begin; end < whole.length; ++end) {
      expect(() => linkOf(whole.slice(0, end), project)).toThrow(kUnreadable);
    }
  });
  it('is refused before it is drawn', () => {
    const { goal } = environment;
    const circle = { x_m: 0, y_m: 0, radius_m: 1 };
    const bad: unknown[] = [
      7, [], 'rest', {}, { ...environment, name: 1 }, { ...environment, obstacles: {} },
      { ...environment, goal: { ...goal, x_m: '0"/><script>' } },
      { ...environment, goal: { x_m: 0, y_m: 0 } },
      { ...environment, goal: { ...goal, colour: 1 } }, { ...environment, start: 'moving' },
      { ...environment, start: { backbone: [[0, 0]] } }, { ...environment, start: null },
      ...[{}, { circle, rectangle: circle }, { circle: { x_m: 0, y_m: 0 } },
        { circle: { ...circle, x_m: null } },
        { polygon: [[0, 0], [1, 1]] }, { polygon: [[0, 0], [1, 1], [1]] }, { star: circle }]
        .map((obstacle) => ({ ...environment, obstacles: [obstacle] })),
    ];
    for (const scene of bad) {
      expect(() => linkOf(linkTo(scene), project), JSON.stringify(scene)).toThrow(kUnreadable);
    }
  });
  it('is refused where it is longer than any scene by hand', () => {
    const obstacles = Array(10_000).fill(environment.obstacles[0]);
    expect(() => linkOf(linkTo({ ...environment, obstacles }), project)).toThrow(kUnreadable);
  });
});
