import { expect, it, vi } from 'vitest';
import { Opening } from '../src/opening';
import { LivePlanner } from '../src/planner';

/** A page with a plan of its own, and what the studio was asked for. */
function page(answer: () => Response = () => new Response('{}')) {
  const sent: { request: number; plan: string; arm: string; model: string }[] = [];
  vi.stubGlobal('fetch', async (_: string, { body }: { body: string }) => {
    sent.push(JSON.parse(body));
    return answer();
  });
  const app = {
    tab: 't', armName: 'a', model: '', isInFile: true, environment: { name: 'e' }, linked: [] as unknown[], said: '',
    project: { environments: ['environments/mine.yaml'] },
    planner: new LivePlanner(() => 't', () => {}),
    open: async () => {
      app.planner.forget();
      return true;
    },
    choose: (model: string) => (app.model = model),
    link: (environment: unknown) => app.linked.push(environment),
    attempt: (work: () => Promise<void>) => work().catch((error: Error) => (app.said = error.message)),
  };
  app.planner.take({ cost_kpa: 1 } as never);
  const opening = new Opening(app as never);
  const opened = (environment: string) =>
    opening.onOpened({ request: sent[0].request, arm: 'a', model: 'm', environment, plan: { cost_kpa: 2 } as never });
  return { app, opening, sent, opened };
}

it('a plan is opened with what it was made for, and stands as if it were found here', async () => {
  const { app, opening, sent, opened } = page();
  const follows = vi.fn();
  opening.ask('plans/a.json', follows);
  await vi.waitFor(() => expect(sent).toHaveLength(1));
  expect(sent[0]).toMatchObject({ plan: 'plans/a.json', arm: 'a', model: '' });
  expect(app.planner.isCurrent).toBe(false);
  await opened('environments/mine.yaml');
  expect([app.planner.plan?.cost_kpa, app.planner.isCurrent, app.model, app.isInFile]).toEqual([2, true, 'm', true]);
  expect(app.linked).toEqual([null]);
  expect(follows).toHaveBeenCalledOnce();
});

it('the scene of a run’s plan is in no file that the page offers', async () => {
  const { app, opening, sent, opened } = page();
  opening.ask('runs/r.plans/00.json', () => {});
  await vi.waitFor(() => expect(sent).toHaveLength(1));
  await opened('runs/r.plans/00.yaml');
  expect(app.isInFile).toBe(false);
  expect(app.linked).toEqual([app.environment]);
});

it('where a plan is refused, the one before stays', async () => {
  const { app, opening } = page(() => new Response('{"error": "no"}', { status: 400 }));
  opening.ask('plans/a.json', () => {});
  await vi.waitFor(() => expect(app.said).toBe('no'));
  expect([app.planner.plan?.cost_kpa, app.planner.isCurrent]).toEqual([1, true]);
});

it('a plan that nobody waits for any more is not shown', async () => {
  const { app, opening, sent, opened } = page();
  const follows = vi.fn();
  opening.ask('plans/a.json', follows);
  await vi.waitFor(() => expect(sent).toHaveLength(1));
  app.planner.giveUp();
  await opened('environments/mine.yaml');
  expect(app.planner.plan).toBeNull();
  expect(follows).not.toHaveBeenCalled();
});
