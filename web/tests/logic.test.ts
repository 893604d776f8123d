import { describe, expect, it } from 'vitest';
import { fitted, gridStep_m, panned, thingLabels, toPixels, toWorld, zoomed } from '../src/camera';
import { History } from '../src/history';
import { centreline, frameAt, sampled, tubeRadii } from '../src/shape';

describe('history', () => {
  it('undoes and redoes step by step', () => {
    const history = new History(0);
    history.set(1);
    history.set(2);
    history.undo();
    expect(history.now).toBe(1);
    history.redo();
    expect(history.now).toBe(2);
    history.undo();
    history.undo();
    history.undo();
    expect(history.now).toBe(0);
    expect(history.canUndo).toBe(false);
  });
  it('takes a drag for one step, and a click for none', () => {
    const history = new History(0);
    history.begin();
    [1, 2, 3].forEach((value) => history.change(value));
    history.end();
    history.begin();
    history.end();
    history.undo();
    expect(history.now).toBe(0);
  });
  it('forgets what was undone once something new is done', () => {
    const history = new History(0);
    history.set(1);
    history.undo();
    history.set(2);
    expect(history.canRedo).toBe(false);
  });
});

describe('camera', () => {
  const camera = { x: 0.3, y: -0.1, m_per_px: 0.002, width: 800, height: 600 };
  it('goes there and back', () => {
    const [x, y] = toWorld(camera, toPixels(camera, [0.123, 0.456]));
    expect(x).toBeCloseTo(0.123);
    expect(y).toBeCloseTo(0.456);
    expect(toPixels(camera, [0.3, 0.1])[1]).toBeLessThan(300);
  });
  it('keeps the point under the pointer when it zooms, and moves with the hand', () => {
    const at = toWorld(camera, [100, 200]);
    expect(toWorld(zoomed(camera, 3, [100, 200]), [100, 200])[0]).toBeCloseTo(at[0]);
    expect(toWorld(panned(camera, 50, -30), [150, 170])[1]).toBeCloseTo(at[1]);
  });
  it('fits a box', () => {
    const fit = fitted(camera, [-1, -1], [1, 3]);
    for (const corner of [[-1, -1], [1, 3]] as [number, number][]) {
      const [px, py] = toPixels(fit, corner);
      expect(px).toBeGreaterThan(0);
      expect(px).toBeLessThan(800);
      expect(py).toBeGreaterThan(0);
      expect(py).toBeLessThan(600);
    }
  });
  it('has grid lines at round distances', () => {
    for (const m_per_px of [0.0003, 0.001, 0.0021, 0.01]) {
      const step = gridStep_m({ ...camera, m_per_px });
      expect(step / m_per_px).toBeGreaterThanOrEqual(72 - 1e-9);
      expect([1, 2, 5]).toContain(Number(step.toExponential().slice(0, 1)));
    }
  });
});

describe('numbers in the picture', () => {
  it('stand in the middles of obstacles, and above the corners of the one that is selected', () => {
    const camera = { x: 0, y: 0, m_per_px: 0.001, width: 400, height: 200 };
    const environment = { obstacles: [
      { circle: { x_m: 0.1, y_m: 0.05, radius_m: 0.02 } }, { polygon: [[0, 0], [0.06, 0], [0, 0.03]] },
    ] } as never;
    const middles = [{ at: [300, 50], text: '0' }, { at: [220, 90], text: '1' }];
    expect(thingLabels(camera, environment, 0)).toEqual(middles);
    expect(thingLabels(camera, environment, 1).slice(1)).toEqual(
      [middles[1], { at: [200, 85], text: '0' }, { at: [260, 85], text: '1' }, { at: [200, 55], text: '2' }]);
    expect(thingLabels(camera, null, null)).toEqual([]);
  });
});

describe('shapes', () => {
  it('are arcs between plates: a quarter of a circle', () => {
    const stations = centreline([0, 0, 0, 1, 1, Math.PI / 2], 2);
    expect(stations[1].x).toBeCloseTo(Math.sin(Math.PI / 4));
    expect(stations[1].y).toBeCloseTo(1 - Math.cos(Math.PI / 4));
    expect(stations[1].theta).toBeCloseTo(Math.PI / 4);
    expect(stations[2].x).toBeCloseTo(1);
  });
  it('are straight where the headings are', () => {
    expect(centreline([0, 0, 0, 1, 0, 0], 2)[1]).toMatchObject({ x: 0.5, y: 0 });
  });
  it('have a tube that grows until it is full', () => {
    const tube = { level: 0.95, plate_radius_m: [0, 0.02], start_share: 0.5, full_after_m: 0.1 };
    const start = [0, 0, 0, 1, 0, 0];
    expect(tubeRadii(tube, start, start)[1]).toBeCloseTo(0.01);
    expect(tubeRadii(tube, start, [0, 0, 0, 1, 0.05, 0])[1]).toBeCloseTo(0.015);
    expect(tubeRadii(tube, start, [0, 0, 0, 1, 0.5, 0])[1]).toBeCloseTo(0.02);
    expect(tubeRadii({ ...tube, full_after_m: 0 }, start, start)[1]).toBeCloseTo(0.02);
  });
  it('hold at their last frame', () => {
    expect(frameAt([1, 2, 3], 20, 0.05)).toBe(2);
    expect(frameAt([1, 2, 3], 20, 9)).toBe(3);
    expect(sampled([0, 1, 2, 3, 4, 5, 6], 3)).toEqual([0, 3, 6]);
  });
});
