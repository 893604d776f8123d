// From VENT to the driver, under load: 200 requests per second, bad ones among them, and a search in each of three other tabs.
//   node tests/measure_vent.mjs [RUNS]
// Times are those of the monotonic clock: when the request leaves, and when the device behind `limber virtual-arm --serve` is told.

import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { network, program, startStudio } from './studio.mjs';

const runs = Number(process.argv[2] ?? 20);
const log = join(mkdtempSync(join(tmpdir(), 'limber_vent_')), 'device.jsonl');
const studio = await startStudio('--model', network, '--driver', `exec:"${program}" virtual-arm --serve --force --device-log "${log}"`);
const { origin } = new URL(studio.address);
const Cookie = (await fetch(studio.address, { redirect: 'manual' })).headers.get('set-cookie').split(';')[0];
const headers = { Cookie, Origin: origin, 'Content-Type': 'application/json' };
const now_s = () => Number(process.hrtime.bigint()) / 1e9;
const quantile = (values, share) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];

/** Asked again where a crowd of connections cost it its own, as the page does; the first may have done what it was to do. */
async function post(path, body) {
  for (;;) {
    try {
      return await (await fetch(`${origin}/api/${path}`, { method: 'POST', headers, body: JSON.stringify(body) })).json();
    } catch {
      // once more
    }
  }
}

/** A tab: its id, and `until(kind, test)` for the next event that passes. */
async function openTab() {
  const reader = (await fetch(`${origin}/api/events`, { headers })).body.getReader();
  const waiting = new Set();
  (async () => {
    let text = '';
    for (let piece = await reader.read(); !piece.done; piece = await reader.read()) {
      text += new TextDecoder().decode(piece.value);
      const events = text.split('\n\n');
      text = events.pop();
      for (const event of events) {
        const [, kind, json] = event.match(/^event: (\w+)\ndata: (.*)$/s) ?? [];
        for (const one of waiting) {
          if (one.kind === kind && one.test(JSON.parse(json))) {
            waiting.delete(one);
            one.resolve(JSON.parse(json));
          }
        }
      }
    }
  })().catch(() => {});
  const until = (kind, test = () => true) => new Promise((resolve) => waiting.add({ kind, test, resolve }));
  return { until, id: (await until('tab')).id };
}

const environment = await (await fetch(`${origin}/api/environment?arm=limber:three_segment&name=limber:01_pillar`, { headers })).json();
const { first_arm, first_model } = await (await fetch(`${origin}/api/project`, { headers })).json();
const question = (tab, time_limit_s) => ({
  tab: tab.id, request: 1, arm: first_arm, model: first_model, environment, time_limit_s, seed: 1, tree: false, limit_scale: 1, margin_m: null,
});
const own = await openTab();
const planned = own.until('result');
await post('plan', question(own, 2));
await planned;
const others = [await openTab(), await openTab(), await openTab()];

let loading = true;
const counts = {};
const load = (async () => {
  const kinds = [
    ['GET', '/api/project'], ['GET', '/api/arm?name=limber:three_segment'], ['GET', '/api/environment?name=../x&arm=y'],
    ['POST', '/api/stop', '{'], ['POST', '/api/drive', '{}'], ['GET', '/nothing'], ['GET', '/assets/studio.js'],
    ['POST', '/api/arm/run', '{"tab":"x","lease":"y","limit_scale":1,"replan":false,"obstacle":false}'],
  ];
  for (let k = 0; loading; ++k) {
    const [method, path, body] = kinds[k % kinds.length];
    const count = (what) => (counts[what] = (counts[what] ?? 0) + 1);
    fetch(origin + path, { method, headers, body }).then((answer) => answer.arrayBuffer().then(() => count(answer.status))).catch(() => count('lost'));
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
})();

const times_ms = [];
for (let run = 0; run < runs; ++run) {
  for (const other of others) await post('plan', question(other, 20));
  let lease;
  while (!lease) ({ lease } = await post('arm/arm', { confirmed: true }));
  const beat = setInterval(() => post('arm/lease', { lease }), 200);
  const moving = own.until('arm_frame', ({ time_s }) => time_s > 0.5);
  await post('arm/run', { lease, tab: own.id, limit_scale: 1, replan: false, obstacle: false });
  await moving;
  await new Promise((resolve) => setTimeout(resolve, (run * 17) % 50)); // anywhere in a frame
  const over = own.until('arm', ({ state }) => state === 'off');
  const pressed_s = now_s();
  await post('arm/vent', {});
  const { message } = await over;
  clearInterval(beat);
  if (!message.startsWith('VENT was pressed; vented')) throw new Error(message);
  const lines = readFileSync(log, 'utf8').trim().split('\n').map((line) => JSON.parse(line));
  const vented = lines.slice(lines.findIndex(({ event }) => event === 'set')).find(({ event }) => event === 'vent');
  times_ms.push(1000 * (vented.at_s - pressed_s));
}
loading = false;
await load;
console.log(`VENT: ${runs} times, median ${quantile(times_ms, 0.5).toFixed(1)} ms, 95 % ${quantile(times_ms, 0.95).toFixed(1)} ms, at most ${Math.max(...times_ms).toFixed(1)} ms`);
console.log('answers by status:', counts);
await studio.stop();
process.exit(0);
