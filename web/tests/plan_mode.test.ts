import { expect, it, vi } from 'vitest';
import { PlanMode } from '../src/plan_mode';
import { fakePage } from './fake_page';

it('a file is replaced under the name that was asked about, whatever is typed meanwhile', async () => {
  fakePage();
  const sent: { name: string; overwrite: boolean }[] = [];
  vi.stubGlobal('fetch', async (_: string, { body }: { body: string }) => {
    sent.push(JSON.parse(body));
    return sent.length === 1
      ? new Response('{"error": "plans/a.json is there already"}', { status: 412 })
      : new Response('{"name": "plans/a.json"}');
  });
  const questions: string[] = [];
  const mode = new PlanMode({
    tab: 't', confirms: (question: string) => {
      questions.push(question);
      fields.name.value = 'b';
      return true;
    },
  } as never);
  const fields = mode as unknown as { name: { value: string }; save: (path: string, body: object) => Promise<string> };
  fields.name.value = 'a ';
  expect(await fields.save('plan/save', {})).toBe('plans/a.json');
  expect(questions).toEqual(['plans/a.json is there already. Replace it?']);
  expect(sent.map(({ name, overwrite }) => [name, overwrite])).toEqual([['a', false], ['a', true]]);
});

it('a plan is saved with its environment where no file has that', async () => {
  fakePage();
  const sent: string[] = [];
  vi.stubGlobal('fetch', async (path: string, { body }: { body: string }) => {
    sent.push(path);
    if (path === '/api/plan/save') expect(JSON.parse(body).plan).toBe(7);
    return new Response(`{"name": "${path}"}`);
  });
  const said: string[] = [];
  const app = {
    project: { environments: [], plans: [] }, environment: {}, isChanged: true, isInFile: true, say: (text: string) => said.push(text), link: () => {},
    planner: { number: 7 },
    history: { change: () => {} },
  };
  const mode = new PlanMode(app as never) as unknown as { savePlan: () => Promise<void>; name: { isConnected: boolean } };
  mode.name.isConnected = false;
  await mode.savePlan();
  expect(said).toEqual(['Saved /api/environment and /api/plan/save']);
  expect(app.project).toEqual({ environments: ['/api/environment'], plans: ['/api/plan/save'] });
  app.isChanged = false;
  await mode.savePlan();
  app.isInFile = false; // but of a link
  await mode.savePlan();
  const [environment, plan] = ['/api/environment', '/api/plan/save'];
  expect(sent).toEqual([environment, plan, plan, environment, plan]);
});

it('what was grabbed in one scene is not dragged into the next', () => {
  fakePage();
  const goal = { x_m: 0.3, y_m: 0.1, theta_rad: null, position_tolerance_m: 0.02, orientation_tolerance_rad: 0.2 };
  const changes: unknown[] = [];
  let ends = 0;
  const mode = new PlanMode({
    environment: { goal, obstacles: [] }, selected: null, select: () => {}, edited: () => {}, refresh: () => {},
    endWork: () => {}, planner: { searching: false, giveUp: () => {}, end: () => {}, hurry: () => {} },
    history: { begin: () => {}, change: (value: unknown) => changes.push(value), end: () => { ++ends; } },
  } as never);
  expect(mode.down([0.3, 0.1], 0.05)).toBe(true);
  mode.drag([0.31, 0.1], 0);
  expect(changes).toHaveLength(1);
  mode.leave();
  mode.drag([0.4, 0.1], 0);
  expect(changes).toHaveLength(1);
  expect(ends).toBe(1);
});
