import { describe, expect, it, vi } from 'vitest';
import { LivePlanner, type PlanQuestion } from '../src/planner';

const question = { arm: 'a', model: '', time_limit_s: 1, tree: false } as PlanQuestion;
const plan = (request: number) => ({ request }) as never;

describe('a plan', () => {
  it('of the last question that was sent is shown, while the newest of those that follow waits', async () => {
    const sent: number[] = [];
    const answers: (() => void)[] = [];
    vi.stubGlobal('fetch', (_: string, { body }: { body: string }) => {
      sent.push(JSON.parse(body).request);
      return new Promise((resolve) => answers.push(() => resolve(new Response('{}'))));
    });
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
  });

  it('is stale once another is asked for, also while there is no tab', () => {
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
