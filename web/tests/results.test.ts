import { describe, expect, it } from 'vitest';
import type { Row, TrialRun } from '../src/api';
import { coveredShare, endOf, playOf, wayOf } from '../src/results';

const run: TrialRun = {
  plan: 'plans/a.json', status: 'solved', cost_kpa: 400, goal_reached: true, collided: false, stopped_ahead: false,
  distance_to_goal_cm: 0.314,
};
const row = { environment: '01', model: 'network', planner: 'default', controller: 'open', disturbance: '' } as Row;

describe('an experiment', () => {
  it('says how a run ended', () => {
    expect(endOf(run)).toBe('arrives, 0.31 cm');
    expect(endOf({ ...run, goal_reached: false })).toBe('misses, 0.31 cm');
    expect(endOf({ ...run, collided: true })).toBe('collides, 0.31 cm');
    expect(endOf({ ...run, goal_reached: false, stopped_ahead: true })).toBe('stops, 0.31 cm');
    expect(endOf({ ...run, goal_reached: null, collided: null, distance_to_goal_cm: null })).toBe('not executed');
    expect(endOf({ ...run, status: 'limit' })).toBe('no plan');
  });
  it('is played as its row was executed, and names what is not', () => {
    expect(playOf({ ...row, controller: 'replan', disturbance: 'obstacle' })).toEqual({ options: { replan: true, obstacle: true }, leftOut: '' });
    expect(playOf({ ...row, controller: 'jacobian', disturbance: 'tip_load=0.1,obstacle' }))
      .toEqual({ options: { replan: false, obstacle: true }, leftOut: 'jacobian, tip_load=0.1' });
    expect(playOf(row)).toEqual({ options: { replan: false, obstacle: false }, leftOut: '' });
  });
  it('leaves out of a row what is as usual', () => {
    expect(wayOf(row)).toBe('network');
    expect(wayOf({ ...row, model: 'no_load', controller: 'replan', disturbance: 'tip_load' }))
      .toBe('simple model, replan, tip_load');
  });
});

describe('coverage', () => {
  it('is the share of cells with a frame', () => {
    expect(coveredShare([0, 3, 0, 1])).toBe(0.5);
  });
});
