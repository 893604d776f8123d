import { describe, expect, it } from 'vitest';
import template from '../public/animation.html?raw';
import { animationOf, animationPage, motionOf } from '../src/animation_data';
import type { Arm, Environment, Motion, Track, TrackKey } from '../src/api';
import { durationOf, environmentAt, figuresAt, mainOf, possible } from '../src/motion';
import { packed, unpacked } from '../src/packing';
import { chartsOf } from '../src/plots';
import { SvgBrush } from '../src/svg_brush';

const kPlates = 16;
const arm = {
  name: 'three', command: { name: 'pressure', unit: 'kPa' }, length_m: 0.705, actuator_radius_m: 0.0125,
  segments: [5, 5, 5].map((gaps) => ({ length_m: 0.235, width_m: 0.05, gaps, lower_kpa: -100, upper_kpa: 100 })),
  rest: Array(3 * kPlates).fill(0), reach: { cell_m: 0.01, middles_m: [1, 2] },
} as Arm;
const environment = { name: 'a </script> b', obstacles: [], start: 'rest', goal: { x_m: 0, y_m: 0, position_tolerance_m: 0.02 } } as Environment;

/** An arm that waves, its tip at up to 1 m/s. */
function track(key: TrackKey, frames: number): Track {
  const shape = (k: number) => Array.from({ length: kPlates }, (_, i) => {
    const turn = (i / kPlates) * 1.3 * Math.sin(k / 9 + key.length);
    return [0.047 * i * Math.cos(turn), 0.047 * i * Math.sin(turn), 2 * turn];
  }).flat();
  const all = Array.from({ length: frames }, (_, k) => k);
  return {
    key, outcome: 'ends <here>', shapes: all.map(shape),
    pressures_kpa: all.map((k) => [80 * Math.sin(k / 9), -40, 0]), clearances_m: all.map((k) => (k < 3 ? null : 0.01 * k)),
  };
}
const motion = (frames: number): Motion => ({
  frame_rate_hz: 20, setpoints_kpa: Array.from({ length: frames }, (_, k) => [k % 90, -40, 0]),
  appeared: { time_s: 1, obstacle: { circle: { x_m: 1, y_m: 2, radius_m: 0.02 } } },
  tracks: [track('simple', frames), track('network', frames), track('arm', frames)],
});

describe('packing', () => {
  it('gives back every number to half of its unit', () => {
    const frames = [[0, -1.23456, 1e3], [0.5, 2, -1e3], [0.5, 2, 0]];
    const units = [1e-4, 1e-3, 0.5];
    const back = unpacked(packed(frames, units), 3, units);
    expect(back).toHaveLength(3);
    back.forEach((frame, k) => frame.forEach((value, i) => expect(Math.abs(value - frames[k][i])).toBeLessThanOrEqual(units[i] / 2 + 1e-12)));
  });
  it('takes one character for a number that stands still', () => {
    expect(packed([[5, 5], [5, 5]], [1])).toHaveLength(4);
    expect(packed([], [1])).toBe('');
  });
});

describe('the animation', () => {
  it('of 100 s and three tracks fits into 1 MB, and comes back', () => {
    const whole = motion(2001);
    const page = animationPage(animationOf('t', arm, environment, whole), template, '', 'x'.repeat(20_000), '');
    expect(page.length).toBeLessThan(1_000_000);
    const json = page.match(/id="data">(.*)<\/script>/)![1];
    const back = motionOf(JSON.parse(json));
    expect(durationOf(back)).toBe(100);
    expect(back.tracks[1].shapes[1234][46]).toBeCloseTo(whole.tracks[1].shapes[1234][46], 3);
    expect(back.appeared).toEqual(whole.appeared);
  });
  it('is of one piece whatever names it holds', () => {
    const page = animationPage(animationOf('<b>&', arm, environment, motion(2)), template, 's', 'a("</script>")', '');
    expect(page.match(/<\/script>/g)).toHaveLength(2);
    expect(page).toContain('<title>&#60;b&#62;&#38;</title>');
    expect(page).toContain('ends &#60;here&#62;');
  });
});

describe('a motion', () => {
  it('shows what was measured whole, and predictions outlined behind it', () => {
    const now = motion(40);
    expect(mainOf(now).key).toBe('arm');
    const figures = figuresAt(now, new Set<TrackKey>(['simple', 'arm']), 0.5);
    expect(figures.map(({ colour, outlined }) => [colour, outlined])).toEqual([['arm', false], ['simple', true]]);
    expect(figures[0].trail).toHaveLength(11);
  });
  it('shows no track that ended before its first frame', () => {
    const now = { ...motion(40), tracks: [track('simple', 40), track('arm', 0)] };
    expect(mainOf(now).key).toBe('simple');
    const figures = figuresAt(now, new Set<TrackKey>(['simple', 'arm']), 0.5);
    expect(figures.map(({ colour, outlined }) => [colour, outlined])).toEqual([['simple', false]]);
  });
  it('has an obstacle from when it appeared', () => {
    expect(environmentAt(environment, motion(40), 0.9).obstacles).toHaveLength(0);
    expect(environmentAt(environment, motion(40), 1).obstacles).toHaveLength(1);
  });
  it('is plotted: pressures of each segment, misses, clearance', () => {
    const now = motion(40);
    const charts = chartsOf(now, mainOf(now), environment.goal, 'kPa');
    expect(charts.map(({ title }) => title)).toEqual([
      'Pressure of segment 0', 'Pressure of segment 1', 'Pressure of segment 2', 'Tip from the arm’s', 'Tip from the goal’s centre', 'Clearance']);
    expect(charts[0].series.map(({ swatch }) => swatch)).toEqual(['set', 'network', 'arm']);
    expect(charts[3].series[0].values[0]).toBeGreaterThan(0);
    expect(charts[5].series[0].values.slice(0, 4)).toEqual([null, null, null, 3]);
  });
});

describe('drawings', () => {
  it('have pixels from the top left, and opacity only where there is some', () => {
    const brush = new SvgBrush({ x: 0, y: 0, m_per_px: 0.01, width: 200, height: 100 });
    brush.begin();
    brush.line([0, 0], [0.5, 0.25], 0.02, [1, 0, 0, 1]);
    brush.disc([0, 0], 0.1, [0, 0, 1, 0.5]);
    expect(brush.text).toBe(
      '<path fill="none" stroke-linejoin="round" stroke-width="2.00" d="M100.00 50.00L150.00 25.00" stroke="rgb(255,0,0)"/>' +
      '<circle cx="100.00" cy="50.00" r="10.00" fill="rgb(0,0,255)" fill-opacity="0.500"/>');
  });
});

describe('a run', () => {
  it('is closed loop only with a network, whatever was ticked before another model was chosen', () => {
    const ticked = { replan: true, obstacle: true };
    expect(possible(ticked, 'model.safetensors')).toEqual(ticked);
    expect(possible(ticked, '')).toEqual({ replan: false, obstacle: true });
  });
});
