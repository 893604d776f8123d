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
    meanwhile: () => {}, // while the arm and the environment are on their way
    open: async (_arm: string, _environment: string, _link: null, isWanted: () => boolean) => {
      await Promise.resolve();
      app.meanwhile();
      if (!isWanted()) return false;
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
    opening.onOpened({ request: sent[0].request, arm: 'a', model: 'm', environment, plan: { request: sent[0].request, cost_kpa: 2 } as never });
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
  expect(app.planner.number).toBe(sent[0].request);
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

it('where nobody knows whether it was opened, the one before is no more', async () => {
  const { app, opening } = page(() => {
    throw new Error('lost');
  });
  opening.ask('plans/a.json', () => {});
  await vi.waitFor(() => expect(app.said).toBe('The studio does not answer.'));
  expect([app.planner.plan, app.planner.isAwaited(2 ** 32 + 1)]).toEqual([null, false]);
});

it('another plan that is opened while the first one’s scene comes is the one that is shown', async () => {
  const { app, opening, sent, opened } = page();
  const [first, second] = [vi.fn(), vi.fn()];
  opening.ask('plans/a.json', first);
  await vi.waitFor(() => expect(sent).toHaveLength(1));
  app.meanwhile = () => opening.ask('plans/b.json', second);
  await opened('environments/mine.yaml');
  expect([app.planner.isCurrent, app.planner.plan?.cost_kpa, app.model]).toEqual([false, undefined, '']);
  await vi.waitFor(() => expect(sent).toHaveLength(2));
  app.meanwhile = () => {};
  sent.shift();
  await opened('environments/mine.yaml');
  expect(app.planner.number).toBe(sent[0].request);
  expect(first).not.toHaveBeenCalled();
  expect(second).toHaveBeenCalledOnce();
});

it('an obstacle that is dragged meanwhile stays, and its plan is awaited', async () => {
  const { app, opening, sent, opened } = page();
  const follows = vi.fn();
  opening.ask('plans/a.json', follows);
  await vi.waitFor(() => expect(sent).toHaveLength(1));
  app.meanwhile = () => app.planner.ask({ environment: { name: 'dragged' } } as never, 0);
  await opened('environments/mine.yaml');
  expect([app.planner.searching, app.planner.isCurrent, app.model]).toEqual([true, false, '']);
  expect(follows).not.toHaveBeenCalled();
});

it('where its scene is refused, no plan is left', async () => {
  const { app, opening, sent, opened } = page();
  opening.ask('plans/a.json', () => {});
  await vi.waitFor(() => expect(sent).toHaveLength(1));
  app.meanwhile = () => {
    throw new Error('gone');
  };
  await expect(opened('environments/mine.yaml')).rejects.toThrow('gone');
  expect([app.planner.plan, app.planner.isAwaited(sent[0].request)]).toEqual([null, false]);
});
