import { expect, it, vi } from 'vitest';
import { Player } from '../src/player';

/** As much of a page as a player needs. */
function fakePage(): { frame: (now_ms: number) => void } {
  let waiting: ((now_ms: number) => void)[] = [];
  const element = () => ({ append: () => {}, setAttribute: () => {}, addEventListener: () => {}, hidden: false });
  vi.stubGlobal('document', { createElement: element });
  vi.stubGlobal('Node', class {});
  vi.stubGlobal('requestAnimationFrame', (step: (now_ms: number) => void) => waiting.push(step));
  return {
    frame: (now_ms) => {
      const steps = waiting;
      waiting = [];
      steps.forEach((step) => step(now_ms));
    },
  };
}

it('a player that is stopped and started within a frame plays at its own speed', () => {
  const { frame } = fakePage();
  vi.stubGlobal('performance', { now: () => 0 });
  let shown = 0;
  const player = new Player(() => 10, () => ++shown);
  player.toggle();
  player.toggle();
  player.toggle();
  shown = 0;
  for (const now_ms of [100, 200, 300]) frame(now_ms);
  expect(player.time_s).toBeCloseTo(0.3);
  expect(shown).toBe(3);
});
