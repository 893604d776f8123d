import { beforeEach, expect, it, vi } from 'vitest';
import type { Followed } from '../src/api';
import { FollowMode } from '../src/follow_mode';
import { fakePage, type FakeElement } from './fake_page';

let answer: () => Promise<Response>;
const sent: { request: number }[] = [];
const says = (panel: FakeElement, words: string) => panel.textContent.includes(words);
const stroke = [[0.3, 0.1], [0.32, 0.12], [0.34, 0.14], [0.36, 0.16]] as [number, number][];

function draw(mode: FollowMode, points: [number, number][], isCut = false): void {
  mode.down(points[0]);
  points.slice(1).forEach((point) => mode.drag(point));
  mode.up(isCut);
}
function entered(): { mode: FollowMode; panel: FakeElement } {
  const panel = fakePage()('panel');
  vi.stubGlobal('matchMedia', () => ({ addEventListener: () => {} }));
  vi.stubGlobal('ResizeObserver', class { observe(): void {} });
  vi.stubGlobal('fetch', (_: string, { body }: { body: string }) => {
    sent.push(JSON.parse(body));
    return answer();
  });
  const mode = new FollowMode({
    arm: { length_m: 0.7, rest: [0, 0, 0] }, armName: 'a', environment: {}, stage: { draw: () => {} },
    attempt: (work: () => Promise<void>) => work(),
  } as never);
  mode.enter(panel as never);
  return { mode, panel };
}
beforeEach(() => {
  sent.length = 0;
  answer = async () => new Response('{}');
});

it('a tap and a pinch leave the path and its run as they are', async () => {
  const { mode, panel } = entered();
  draw(mode, stroke);
  await vi.waitFor(() => expect(sent).toHaveLength(1));
  const track = { key: 'virtual_arm', outcome: 'off by 0.3 cm', shapes: [], pressures_kpa: [], clearances_m: [] };
  Object.assign(mode, { run: { tracks: [track], setpoints_kpa: [], frame_rate_hz: 20 } as unknown as Followed });
  const path = mode.scene().path;
  draw(mode, [[0.5, 0.2]]);
  draw(mode, stroke.map(([x, y]) => [x + 0.1, y]), true);
  expect(mode.scene().path).toBe(path);
  expect((mode as unknown as { run: unknown }).run).not.toBeNull();
  expect(sent).toHaveLength(1);
  expect(says(panel, 'There is no path')).toBe(false);
  draw(mode, stroke);
  await vi.waitFor(() => expect(sent).toHaveLength(2));
});

it('what is refused is said in place of "the arm follows"', async () => {
  answer = async () => new Response('{"error": "the path is 2 m from the base"}', { status: 400 });
  const { mode, panel } = entered();
  draw(mode, stroke);
  expect(says(panel, 'The arm follows')).toBe(true);
  await vi.waitFor(() => expect(says(panel, 'the path is 2 m from the base')).toBe(true));
  expect(says(panel, 'The arm follows')).toBe(false);
});
