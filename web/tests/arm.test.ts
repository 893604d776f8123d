import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { listen, post, vent } from '../src/api';
import { ArmLink } from '../src/arm_link';

type Sent = { path: string; signal?: AbortSignal; answer: (status?: number) => void };

/** Requests that wait until they are answered. */
function heldFetch(): Sent[] {
  const sent: Sent[] = [];
  vi.stubGlobal('fetch', (path: string, { signal }: RequestInit) => new Promise((resolve, reject) => {
    signal?.addEventListener('abort', () => reject(signal.reason));
    const answer = (status = 200) => resolve(new Response('{"lease": "secret"}', { status }));
    sent.push({ path: path.replace('/api/', ''), signal: signal ?? undefined, answer });
  }));
  return sent;
}

describe('requests about the arm', () => {
  it('wait for none about anything else, and one for another', async () => {
    const sent = heldFetch();
    const paths = () => sent.map(({ path }) => path);
    void post('plan', {});
    void post('run', {});
    void post('arm/pause', {});
    void post('arm/stop', {});
    await vi.waitFor(() => expect(paths()).toEqual(['plan', 'arm/pause']));
    sent[1].answer();
    await vi.waitFor(() => expect(paths()).toEqual(['plan', 'arm/pause', 'arm/stop']));
    sent[0].answer();
    sent[2].answer();
    await vi.waitFor(() => expect(paths()).toContain('run'));
    sent[3].answer();
  });
});

describe('VENT', () => {
  it('makes whatever else is under way give up its connection', async () => {
    const sent = heldFetch();
    const given = Promise.all(['plan', 'arm/stop'].map((path) => expect(post(path, {})).rejects.toThrow('VENT was pressed')));
    await vi.waitFor(() => expect(sent).toHaveLength(2));
    const vented = vent();
    await given;
    sent[2].answer();
    await vented;
  });
});

describe('the event stream', () => {
  class Source {
    static CLOSED = 2;
    readyState = 0;
    onerror = () => {};
    tell: Record<string, (message: { data: string }) => void> = {};
    constructor() {
      sources.push(this);
    }
    addEventListener(kind: string, listener: (message: { data: string }) => void): void {
      this.tell[kind] = listener;
    }
  }
  let sources: Source[];
  beforeEach(() => {
    sources = [];
    vi.useFakeTimers();
    vi.stubGlobal('EventSource', Source);
  });
  afterEach(() => void vi.useRealTimers());

  it('is asked for again once it was refused, and not where a browser connects again by itself', () => {
    const lost: boolean[] = [];
    listen({} as never, (isRefused) => lost.push(isRefused), () => {});
    sources[0].onerror();
    vi.advanceTimersByTime(10_000);
    expect(sources).toHaveLength(1);
    sources[0].readyState = Source.CLOSED;
    sources[0].onerror();
    vi.advanceTimersByTime(10_000);
    expect(sources).toHaveLength(2);
    expect(lost).toEqual([false, true]);
  });
  it('that falls silent is noticed, though its connection stays, and heard again with its next word', () => {
    let isHeard = true;
    listen({ arm: () => {} } as never, () => {}, (on) => (isHeard = on));
    const { tell } = sources[0];
    for (const kind of ['beat', 'arm', 'beat']) {
      vi.advanceTimersByTime(1500);
      tell[kind]({ data: '{}' });
      expect(isHeard).toBe(true);
    }
    vi.advanceTimersByTime(2000);
    expect(isHeard).toBe(false);
    tell.beat({ data: '{}' });
    expect(isHeard).toBe(true);
  });
  it('that was lost does not call the next one silent', () => {
    const heard: boolean[] = [];
    listen({} as never, () => {}, (on) => heard.push(on));
    sources[0].readyState = Source.CLOSED;
    sources[0].onerror();
    vi.advanceTimersByTime(2000); // asked for again
    sources[1].tell.beat({ data: '{}' });
    vi.advanceTimersByTime(1500);
    expect(heard).toEqual([true]);
  });
});

describe('the lease worker', () => {
  let sent: Sent[];
  const said: string[] = [];
  const worker = { postMessage: (text: string) => said.push(text), onmessage: (_: { data: string }) => {} };
  beforeEach(async () => {
    vi.useFakeTimers();
    sent = heldFetch();
    said.length = 0;
    vi.stubGlobal('self', worker);
    vi.resetModules();
    await import('../src/lease_worker');
  });
  afterEach(() => void vi.useRealTimers());

  it('renews with one request at a time, and with the next one where an answer does not come', async () => {
    worker.onmessage({ data: 'a' });
    await vi.advanceTimersByTimeAsync(600);
    expect(sent).toHaveLength(1);
    await vi.advanceTimersByTimeAsync(300);
    expect(sent).toHaveLength(2);
    sent[1].answer();
    await vi.advanceTimersByTimeAsync(200);
    expect(sent).toHaveLength(3);
    expect(said).toEqual(['ready']);
  });
  it('says that a lease is over', async () => {
    worker.onmessage({ data: 'a' });
    await vi.advanceTimersByTimeAsync(200);
    sent[0].answer(409);
    await vi.advanceTimersByTimeAsync(1000);
    expect(said).toEqual(['ready', 'over']);
    expect(sent).toHaveLength(1);
  });
  it('gives up its connection at once when there is none to renew, and says nothing of an old one', async () => {
    worker.onmessage({ data: 'a' });
    await vi.advanceTimersByTimeAsync(200);
    worker.onmessage({ data: '' });
    expect(sent[0].signal?.aborted).toBe(true);
    worker.onmessage({ data: 'b' });
    sent[0].answer(409);
    await vi.advanceTimersByTimeAsync(200);
    expect(sent).toHaveLength(2);
    expect(said).toEqual(['ready']);
  });
});

describe('the arm, as a page sees it', () => {
  const told: string[] = [];
  let changes = 0;
  let link: ArmLink;
  let worker: { onmessage: (message: { data: string }) => void };
  beforeEach(() => {
    vi.stubGlobal('window', { addEventListener: () => {} });
    vi.stubGlobal('Worker', class {
      onmessage: (message: { data: string }) => void = () => {};
      constructor() {
        worker = this;
        queueMicrotask(() => this.onmessage({ data: 'ready' }));
      }
      postMessage(lease: string): void {
        told.push(lease);
      }
    });
    link = new ArmLink(() => 'tab', () => ++changes);
  });

  it('moves nothing on the page while it runs for another one', async () => {
    vi.stubGlobal('fetch', async () => new Response('{}'));
    link.onStatus({ state: 'running', message: '', recording: '' });
    const before = changes;
    link.onFrame({} as never);
    expect(changes).toBe(before);
    expect(link.live).toBeNull();
    await link.run({ limit_scale: 1, replan: false, obstacle: false });
    link.onFrame({} as never);
    expect(changes).toBe(before + 1);
    expect(link.live).not.toBeNull();
  });
  it('renews its lease no more once VENT was pressed, nor while its events are refused', async () => {
    vi.stubGlobal('fetch', async () => new Response('{"lease": "secret"}'));
    link.prepare();
    await link.arm();
    told.length = 0;
    link.renews(false);
    link.renews(true);
    await link.vent();
    link.renews(true);
    expect(told).toEqual(['', 'secret', '', '', '']);
  });
  it('takes the arm for armed by another page once its own lease is over, whether or not it saw that end', async () => {
    const armed = { state: 'armed', message: '', recording: '' } as const;
    vi.stubGlobal('fetch', async () => new Response('{"lease": "secret"}'));
    link.prepare();
    await link.arm();
    link.onStatus(armed);
    expect(link.isMine).toBe(true);
    await link.vent(); // and the stream is lost before it says so
    link.onStatus(armed);
    expect(link.isMine).toBe(false);
    await link.arm();
    worker.onmessage({ data: 'over' }); // the answer to the first renewal after a loss
    expect(link.isMine).toBe(false);
  });
  it('says at once that VENT is not answered, goes on trying, and takes a second press for the first', async () => {
    const tries: ((error: Error) => void)[] = [];
    const answers: ((response: Response) => void)[] = [];
    vi.stubGlobal('fetch', () => new Promise((resolve, reject) => {
      answers.push(resolve);
      tries.push(reject);
    }));
    const vented = link.vent();
    expect(link.vent()).toBe(vented);
    expect([tries.length, link.isVenting, link.isUnanswered]).toEqual([1, true, false]);
    tries[0](new Error('timed out'));
    await vi.waitFor(() => expect(tries).toHaveLength(2));
    const before = changes;
    expect(link.isUnanswered).toBe(true);
    tries[1](new Error('timed out'));
    await vi.waitFor(() => expect(tries).toHaveLength(3));
    link.onStatus({ state: 'running', message: '', recording: '' });
    expect([link.isUnanswered, changes - before]).toEqual([true, 1]);
    answers[2](new Response('{}'));
    await vented;
    expect([link.isVenting, link.isUnanswered]).toEqual([false, false]);
  });
  it('keeps saying so once it has given up, until the studio is heard', async () => {
    vi.stubGlobal('fetch', () => Promise.reject(new Error('refused')));
    await expect(link.vent()).rejects.toThrow('does not answer');
    expect([link.isVenting, link.isUnanswered]).toEqual([false, true]);
    link.onStatus({ state: 'off', message: '', recording: '' });
    expect(link.isUnanswered).toBe(false);
  });
});
