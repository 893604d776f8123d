import { beforeEach, expect, it, vi } from 'vitest';
import { PlayMode } from '../src/play_mode';
import { fakePage } from './fake_page';

vi.mock('../src/plots', () => ({ chartsOf: () => [], Plots: class { element = document.createElement('div'); show(): void {} at(): void {} } }));

const sent: { request: number; replan: boolean; obstacle: boolean }[] = [];
const motionOf = (...keys: string[]) => ({
  frame_rate_hz: 20, setpoints_kpa: [[0], [1]], appeared: null,
  tracks: keys.map((key) => ({ key, outcome: `<${key}>`, shapes: [[0, 0, 0], [1, 0, 0]], pressures_kpa: [[0], [1]], clearances_m: [] })),
});
const models = () => ({ ...motionOf('simple', 'network', 'virtual_arm'), request: sent[sent.length - 1].request }) as never;
const byTheArm = motionOf('arm') as never;

function played() {
  const panel = fakePage()('panel');
  const app = {
    project: { driver: 'exec:mine', driver_arm: 'a', driver_limit_scale: 1 }, armName: 'a', model: 'm',
    arm: { segments: [{ lower_kpa: -1, upper_kpa: 1 }], command: { unit: 'kPa' } }, environment: { goal: {} },
    planner: { plan: { setpoints_kpa: [[0]] } as object, isCurrent: true },
    armLink: { status: { state: 'armed', message: '', recording: '' }, isMine: true, isSeen: true, live: null, runs: false, ownRun: false,
      run: async () => void Object.assign(app.armLink, { runs: true, ownRun: true }) },
    said: '', say: (text: string) => (app.said = text),
    refresh: () => mode.refresh(), enter: () => {}, attempt: (work: () => Promise<void>) => work(), endWork: () => {},
  };
  const mode: PlayMode = new PlayMode(app as never);
  const shown = () => panel.textContent.match(/<\w+>/g) ?? [];
  const enter = () => {
    panel.replaceChildren();
    mode.enter(panel as never);
    return vi.waitFor(() => expect(sent.length).toBeGreaterThan(0));
  };
  const press = (name: string) => panel.all.find((one) => one.textContent === name && one.getAttribute('type'))!.fire('click');
  return { app, mode, shown, enter, press };
}
beforeEach(() => {
  sent.length = 0;
  vi.stubGlobal('matchMedia', () => ({ addEventListener: () => {} }));
  vi.stubGlobal('ResizeObserver', class { observe(): void {} });
  vi.stubGlobal('fetch', async (_: string, { body }: { body: string }) => {
    sent.push(JSON.parse(body));
    return new Response('{}');
  });
});

it('the arm’s run is shown although Play is left and entered again while the arm moves', async () => {
  const { mode, shown, enter, press } = played();
  await enter();
  mode.onRun(models());
  press('Play on the arm');
  mode.leave();
  await enter();
  mode.onArmRun(byTheArm);
  expect(shown()).toEqual([]);
  await vi.waitFor(() => expect(sent).toHaveLength(2));
  mode.onRun(models());
  expect(shown()).toEqual(['<simple>', '<network>', '<arm>']);
});

it('the arm’s run of another plan is not shown with this one', async () => {
  const { app, mode, shown, enter, press } = played();
  await enter();
  mode.onRun(models());
  press('Play on the arm');
  app.planner.plan = { setpoints_kpa: [[0]] };
  mode.onArmRun(byTheArm);
  expect(app.said).toMatch('of the plan before');
  mode.onRun(models());
  expect(shown()).toEqual(['<simple>', '<network>', '<virtual_arm>']);
});
