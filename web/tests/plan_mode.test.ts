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
  let done: Promise<void> = Promise.resolve();
  const questions: string[] = [];
  const mode = new PlanMode({
    tab: 't', say: () => {}, attempt: (work: () => Promise<void>) => (done = work()),
    confirms: (question: string) => {
      questions.push(question);
      fields.name.value = 'b';
      return true;
    },
  } as never);
  const fields = mode as unknown as { name: { value: string }; save: (path: string, body: object) => void };
  fields.name.value = 'a ';
  fields.save('plan/save', {});
  await done;
  expect(questions).toEqual(['plans/a.json is there already. Replace it?']);
  expect(sent.map(({ name, overwrite }) => [name, overwrite])).toEqual([['a', false], ['a', true]]);
});
