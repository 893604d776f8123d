import { describe, expect, it, vi } from 'vitest';
import { LivePlanner, type PlanQuestion } from '../src/planner';

const question = { arm: 'a', model: '', time_limit_s: 1, tree: false, margin_m: null } as PlanQuestion;
const plan = (request: number) => ({ request }) as never;

/** Requests that wait until they are answered. @return of each, what it says of `key` */
function heldFetch(key: string): { sent: unknown[]; answers: (() => void)[] } {
  const sent: unknown[] = [];
  const answers: (() => void)[] = [];
  vi.stubGlobal('fetch', (_: string, { body }: { body: string }) => {
    sent.push(JSON.parse(body)[key]);
    return new Promise((resolve) => answers.push(() => resolve(new Response('{}'))));
  });
  return { sent, answers };
}

describe('the live planner', () => {
  it('sends the newest question alone once the first is through', async () => {
    const { sent, answers } = heldFetch('arm');
    const planner = new LivePlanner(() => 'tab', () => {});
    for (const arm of ['1', '2', '3']) planner.ask({ ...question, arm }, 0);
    await vi.waitFor(() => expect(sent).toEqual(['1']));
    answers[0]();
    await vi.waitFor(() => expect(sent).toEqual(['1', '3']));
    answers[1](); // a page's next post waits for it
  });

  it('searches the same scene by other samples where it is asked again, and a new one by the first', async () => {
    const { sent, answers } = heldFetch('seed');
    const planner = new LivePlanner(() => 'tab', () => {});
    const [first, second] = [{}, {}].map((environment) => ({ ...question, environment }) as PlanQuestion);
    for (const [k, [asked, again]] of ([[first, false], [first, true], [first, false], [second, true]] as const).entries()) {
      planner.ask(asked, 0, again);
      await vi.waitFor(() => expect(sent).toHaveLength(k + 1));
      planner.onPlan(plan(k + 1));
      answers[k]();
    }
    expect(sent).toEqual([1, 2, 2, 1]);
  });

  it('keeps no verdict of a question on the one that waited for it', async () => {
    const { sent, answers } = heldFetch('request');
    const planner = new LivePlanner(() => 'tab', () => {});
    planner.ask(question, 0);
    planner.ask(question, 0);
    await vi.waitFor(() => expect(sent).toHaveLength(1));
    planner.onFault(sent[0] as number, 'edges cross');
    expect(planner.fault).toBe('edges cross');
    answers[0]();
    await vi.waitFor(() => expect(sent).toHaveLength(2));
    expect([planner.fault, planner.result, planner.searching]).toEqual(['', null, true]);
    answers[1]();
  });

  it('sends the last question at once when the hand lets go', async () => {
    vi.useFakeTimers();
    const { sent, answers } = heldFetch('arm');
    const planner = new LivePlanner(() => 'tab', () => {});
    for (const arm of ['1', '2']) planner.ask({ ...question, arm }, 0);
    await vi.advanceTimersByTimeAsync(1);
    answers[0]();
    await vi.advanceTimersByTimeAsync(1);
    expect(sent).toEqual(['1']);
    planner.hurry();
    await vi.advanceTimersByTimeAsync(1);
    expect(sent).toEqual(['1', '2']);
    answers[1]();
    vi.useRealTimers();
  });

  it('lets a search go on until it is heard, or for its patience, before the next question ends it', async () => {
    vi.useFakeTimers();
    const sent: number[] = [];
    vi.stubGlobal('fetch', async (_: string, { body }: { body: string }) => {
      sent.push(JSON.parse(body).request);
      return { ok: true, json: async () => ({}) };
    });
    const planner = new LivePlanner(() => 'tab', () => {});
    const ends: ((request: number) => unknown)[] = [
      (request) => planner.onPlan(plan(request)),
      (request) => planner.onResult({ request, status: 'limit', tree: null } as never),
      (request) => planner.onFault(request, 'no'),
      () => {}, // without an answer
    ];
    for (const [i, end] of ends.entries()) {
      planner.ask(question, 0);
      await vi.advanceTimersByTimeAsync(1);
      expect(sent).toHaveLength(2 * i + 1);
      planner.ask(question, 0);
      await vi.advanceTimersByTimeAsync(50);
      expect(sent).toHaveLength(2 * i + 1);
      end(sent[2 * i]);
      await vi.advanceTimersByTimeAsync(i < 3 ? 1 : 40);
      expect(sent).toHaveLength(2 * i + 2);
      planner.forget();
      await vi.advanceTimersByTimeAsync(1);
    }
    vi.useRealTimers();
  });

  it('has no plan for a scene whose question is given up before it is sent', async () => {
    const { sent, answers } = heldFetch('request');
    const planner = new LivePlanner(() => 'tab', () => {});
    planner.ask(question, 0);
    await vi.waitFor(() => expect(sent).toEqual([1]));
    planner.ask(question, 3);
    planner.onPlan(plan(1));
    planner.end();
    expect(planner.isCurrent).toBe(false);
    answers[0]();
  });

  it('shows the plan of the last question that was sent, while the newest of those that follow waits', async () => {
    const { sent, answers } = heldFetch('request');
    const planner = new LivePlanner(() => 'tab', () => {});
    planner.ask(question, 0);
    await vi.waitFor(() => expect(sent).toEqual([1]));
    planner.ask(question, 3);
    planner.ask(question, 5);
    planner.onPlan(plan(1)); // else nothing would be seen during a drag
    expect(planner.isCurrent).toBe(true);
    answers[0]();
    await vi.waitFor(() => expect(sent).toEqual([1, 2]));
    expect(planner.isCurrent).toBe(false);
    planner.onPlan(plan(1));
    expect(planner.isCurrent).toBe(false);
    planner.onPlan(plan(2));
    expect(planner.isCurrent).toBe(true);
    expect(planner.askedAt_ms).toBe(5);
    answers[1]();
  });

  it('drops answers to older questions', () => {
    vi.stubGlobal('fetch', () => new Promise(() => {}));
    const planner = new LivePlanner(() => 'tab', () => {});
    planner.ask(question, 0);
    planner.onPlan(plan(0));
    expect(planner.plan).toBeNull();
    planner.onPlan(plan(1));
    expect(planner.isCurrent).toBe(true);
    planner.onResult({ request: 1, status: 'limit' } as never);
    expect(planner.plan).toBeNull();
    expect(planner.searching).toBe(false);
  });

  it('keeps its plan where another can’t be opened, and plays neither meanwhile', async () => {
    vi.stubGlobal('fetch', () => new Promise(() => {}));
    const planner = new LivePlanner(() => 'tab', () => {});
    planner.ask(question, 0);
    planner.onPlan(plan(1));
    const request = planner.expect();
    expect([planner.isCurrent, planner.isAwaited(request)]).toEqual([false, true]);
    expect(planner.refuse(request)).toBe(true);
    expect(planner.isCurrent).toBe(true);
    planner.take(plan(planner.expect()));
    expect(planner.isCurrent).toBe(true);
    planner.expect();
    planner.giveUp(); // the studio may have opened it
    expect(planner.plan).toBeNull();
  });

  it('has a stale plan once another is asked for while there is no tab', () => {
    vi.stubGlobal('fetch', () => new Promise(() => {}));
    let tab = 'tab';
    const planner = new LivePlanner(() => tab, () => {});
    planner.ask(question, 0);
    planner.onPlan(plan(1));
    tab = '';
    planner.ask(question, 0);
    expect(planner.plan).not.toBeNull();
    expect(planner.isCurrent).toBe(false);
  });
});
