import { describe, expect, it, vi } from 'vitest';
import type { Environment } from '../src/api';
import {
  added, centreOf, dragged, handlesOf, hit, isInside, newObstacle, outlineOf, removed, rotated, stillSelected, withCorner,
} from '../src/environment';
import { keyEdit, tabAfter, viewAct } from '../src/keys';

const environment: Environment = {
  name: 'test',
  start: 'rest',
  obstacles: [
    { circle: { x_m: 0.3, y_m: 0.1, radius_m: 0.05 } },
    { rectangle: { x_m: 0.5, y_m: -0.2, width_m: 0.2, height_m: 0.1, angle_rad: Math.PI / 2 } },
    { polygon: [[0, 0.3], [0.1, 0.3], [0.1, 0.4], [0.05, 0.32]] },
  ],
  goal: { x_m: 0.4, y_m: 0.3, theta_rad: 0.5, position_tolerance_m: 0.02, orientation_tolerance_rad: 0.3 },
};

describe('outlines', () => {
  it('of a turned rectangle are turned', () => {
    const outline = outlineOf(environment.obstacles[1]);
    expect(outline[0][0]).toBeCloseTo(0.55);
    expect(outline[0][1]).toBeCloseTo(-0.3);
    expect(isInside([0.54, -0.11], outline)).toBe(true);
    expect(isInside([0.59, -0.2], outline)).toBe(false);
  });
  it('of a polygon that is not convex leave its notch outside', () => {
    const outline = outlineOf(environment.obstacles[2]);
    expect(isInside([0.09, 0.32], outline)).toBe(true);
    expect(isInside([0.04, 0.33], outline)).toBe(false);
  });
});

describe('hits', () => {
  it('are of what lies there, the goal before obstacles', () => {
    expect(hit(environment, null, [0.32, 0.1], 0.005)).toEqual({ of: 0, part: 'body' });
    expect(hit(environment, null, [0.41, 0.3], 0.005)).toEqual({ of: 'goal', part: 'body' });
    expect(hit(environment, null, [0.9, 0.9], 0.005)).toBeNull();
    const over = added(environment, { circle: { x_m: 0.4, y_m: 0.3, radius_m: 0.1 } });
    expect(hit(over, null, [0.4, 0.3], 0.005)).toEqual({ of: 'goal', part: 'body' });
  });
  it('are of handles only where their thing is selected', () => {
    expect(hit(environment, 0, [0.35, 0.1], 0.01)).toEqual({ of: 0, part: 'size' });
    expect(hit(environment, null, [0.349, 0.1], 0.01)).toEqual({ of: 0, part: 'body' });
    expect(hit(environment, 2, [0.1, 0.4], 0.01)).toEqual({ of: 2, part: 2 });
  });
  it('may be missed by as much as a finger is wide', () => {
    expect(hit(environment, null, [0.44, 0.3], 0.05)).toEqual({ of: 'goal', part: 'body' });
    expect(hit(environment, 'goal', [0.401, 0.3], 0.1)).toEqual({ of: 'goal', part: 'body' });
  });
});

describe('drags', () => {
  it('move whole things, to the millimetre, and change nothing else', () => {
    const next = dragged(environment, { of: 0, part: 'body' }, [0, 0], [0.01234, -0.1]);
    expect(next.obstacles[0]).toEqual({ circle: { x_m: 0.312, y_m: 0, radius_m: 0.05 } });
    expect(next.obstacles.slice(1)).toEqual(environment.obstacles.slice(1));
    expect(next.goal).toBe(environment.goal);
    expect(environment.obstacles[0]).toEqual({ circle: { x_m: 0.3, y_m: 0.1, radius_m: 0.05 } });
  });
  it('resize about the middle, in the own directions of a turned rectangle', () => {
    const next = dragged(environment, { of: 1, part: 'size' }, [0, 0], [0.6, -0.05]);
    const { rectangle } = next.obstacles[1] as { rectangle: { width_m: number; height_m: number } };
    expect(rectangle.width_m).toBeCloseTo(0.3);
    expect(rectangle.height_m).toBeCloseTo(0.2);
    const tiny = dragged(environment, { of: 0, part: 'size' }, [0, 0], [0.3, 0.1]);
    expect(tiny.obstacles[0]).toEqual({ circle: { x_m: 0.3, y_m: 0.1, radius_m: 0.005 } });
  });
  it('of a corner move that corner alone', () => {
    const next = dragged(environment, { of: 2, part: 1 }, [0, 0], [0.2, 0.25]);
    expect(next.obstacles[2]).toEqual({ polygon: [[0, 0.3], [0.2, 0.25], [0.1, 0.4], [0.05, 0.32]] });
  });
  it('turn the goal and a rectangle towards the pointer', () => {
    const goal = dragged(environment, { of: 'goal', part: 'turn' }, [0, 0], [0.4, 0.4]).goal;
    expect(goal.theta_rad).toBeCloseTo(Math.PI / 2, 2);
    const next = dragged(environment, { of: 1, part: 'turn' }, [0, 0], [0.6, -0.2]);
    expect(next.obstacles[1]).toMatchObject({ rectangle: { angle_rad: 0 } });
  });
});

describe('handles', () => {
  it('lie where a drag that does not move leaves everything as it is', () => {
    for (const selected of ['goal', 0, 1, 2] as const) {
      for (const [handle, at] of handlesOf(environment, selected)) {
        const next = dragged(environment, handle, at, at);
        const before = selected === 'goal' ? environment.goal : centreOf(environment.obstacles[selected]);
        const after = selected === 'goal' ? next.goal : centreOf(next.obstacles[selected]);
        if (Array.isArray(before)) (after as number[]).forEach((v, i) => expect(v).toBeCloseTo(before[i]));
        else expect(after).toEqual(before);
      }
    }
  });
});

describe('keys', () => {
  it('move, turn, and leave alone what is not selected', () => {
    expect(keyEdit(environment, null, 'ArrowLeft', false)).toBeNull();
    expect(keyEdit(environment, 0, 'x', false)).toBeNull();
    expect(keyEdit(environment, 'goal', 'ArrowUp', true)?.goal.y_m).toBeCloseTo(0.31);
    expect(keyEdit(environment, 'goal', '[', false)?.goal.theta_rad).toBeCloseTo(0.55);
  });
  it('move the picture, so that what lies in their direction comes into it', () => {
    const stage = { pan: vi.fn(), zoom: vi.fn(), refit: vi.fn() };
    for (const key of ['ArrowRight', 'ArrowUp', '-', '0']) viewAct(stage, key)!();
    expect(stage.pan.mock.calls).toEqual([[-40, 0], [-0, 40]]);
    expect(stage.zoom).toHaveBeenCalledWith(0.8);
    expect(stage.refit).toHaveBeenCalled();
    expect(viewAct(stage, 'Delete')).toBeNull();
  });
  it('turn a polygon about its middle', () => {
    let turned = environment;
    for (let i = 0; i < 4; ++i) turned = rotated(turned, 2, Math.PI / 2);
    const corners = (turned.obstacles[2] as { polygon: number[][] }).polygon;
    const before = (environment.obstacles[2] as { polygon: number[][] }).polygon;
    corners.forEach((p, i) => {
      expect(p[0]).toBeCloseTo(before[i][0], 2);
      expect(p[1]).toBeCloseTo(before[i][1], 2);
    });
  });
});

describe('new and removed obstacles', () => {
  it('come last, and go alone', () => {
    for (const kind of ['circle', 'rectangle', 'polygon']) {
      const next = added(environment, newObstacle(kind, [0.1, 0.2]));
      expect(Object.keys(next.obstacles[3])).toEqual([kind]);
      const [x, y] = centreOf(next.obstacles[3]);
      expect(x).toBeCloseTo(0.1);
      expect(y).toBeCloseTo(0.2);
      expect(removed(next, 3)).toEqual(environment);
    }
  });
});

describe('a polygon', () => {
  it('gets another corner in the middle of its longest edge, also the one that closes it', () => {
    const corners: [number, number][] = [[0, 0], [0.1, 0], [0.2, 0.3]];
    expect(withCorner(corners)).toEqual([[0, 0], [0.1, 0], [0.2, 0.3], [0.1, 0.15]]);
    expect(withCorner([[0, 0], [0.4, 0], [0.2, 0.1]])[1]).toEqual([0.2, 0]);
  });
});

describe('what is selected', () => {
  it('stays the same obstacle when a step is undone or done again', () => {
    const fewer = removed(environment, 0);
    expect(stillSelected(1, fewer, environment)).toBe(2);
    expect(stillSelected(2, environment, fewer)).toBe(1);
    expect(stillSelected(0, environment, fewer)).toBeNull();
    expect(stillSelected('goal', environment, fewer)).toBe('goal');
    const moved = dragged(environment, { of: 1, part: 'body' }, [0.5, -0.2], [0.4, -0.2]);
    expect(stillSelected(1, moved, environment)).toBe(1);
  });
});

describe('the tabs', () => {
  it('are gone through by arrow keys, from the last one to the first', () => {
    expect(['ArrowLeft', 'ArrowRight', 'Home', 'End', 'a'].map((key) => tabAfter(5, 0, key))).toEqual([4, 1, 0, 4, undefined]);
    expect(tabAfter(5, 4, 'ArrowRight')).toBe(0);
  });
});
