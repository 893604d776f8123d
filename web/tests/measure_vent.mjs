// From VENT to the driver, under load: 200 requests per second, bad ones among them, and a plan being searched in every other tab.
//   node tests/measure_vent.mjs [RUNS]
// Times are those of the monotonic clock: when the button is pressed or the request leaves, and when the device behind
// `limber virtual-arm --serve` is told. Half of the vents come from another page's button, half from a script.

import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { network, openPage, program, startBrowser, startStudio } from './studio.mjs';

const runs = Number(process.argv[2] ?? 20);
const kTabs = 3; // beside the one that has armed the arm
const log = join(mkdtempSync(join(tmpdir(), 'limber_vent_')), 'device.jsonl');
const studio = await startStudio('--model', network, '--driver', `exec:"${program}" virtual-arm --serve --force --device-log "${log}"`);
const { origin } = new URL(studio.address);
const browser = await startBrowser();
const now_s = () => Number(process.hrtime.bigint()) / 1e9;
const quantile = (values, share) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];

const page = await openPage(browser, studio.address);
const cookies = (await page.context().cookies()).map(({ name, value }) => `${name}=${value}`).join('; ');
const headers = { Cookie: cookies, Origin: origin, 'Content-Type': 'application/json' };
await page.waitForFunction(() => document.querySelector('.status.good') && !document.querySelector('.status em'));
await page.getByRole('tab', { name: 'Play' }).click();
await page.waitForSelector('.tracks');
const others = [];
for (let i = 0; i < kTabs; ++i) {
  const context = page.context();
  const other = await context.newPage();
  await other.goto(origin);
  await other.getByLabel('Seconds to search for').selectOption('20');
  others.push(other);
}

let loading = true;
const counts = new Map();
const load = (async () => {
  const kinds = [
    ['GET', '/api/project'], ['GET', '/api/arm?name=limber:three_segment'], ['GET', '/api/environment?name=../x&arm=y'],
    ['POST', '/api/stop', '{'], ['POST', '/api/drive', '{}'], ['GET', '/nothing'], ['GET', '/assets/studio.js'],
    ['POST', '/api/arm/run', '{"tab":"x","lease":"y","limit_scale":1,"replan":false,"obstacle":false}'],
  ];
  for (let k = 0; loading; ++k) {
    const [method, path, body] = kinds[k % kinds.length];
    fetch(origin + path, { method, headers, body }).then(async (answer) => {
      await answer.arrayBuffer();
      counts.set(answer.status, (counts.get(answer.status) ?? 0) + 1);
    }, () => counts.set('lost', (counts.get('lost') ?? 0) + 1));
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
})();

const times = { button: [], script: [] };
for (let run = 0; run < runs; ++run) {
  for (const other of others) await other.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.bringToFront();
  await page.getByLabel(/Nobody is within its reach/).check();
  await page.getByRole('button', { name: 'Arm', exact: true }).click();
  await page.getByLabel(/limits that the arm may use/).selectOption({ label: '100 %' });
  await page.getByRole('button', { name: 'Play on the arm' }).click();
  await page.waitForFunction(() => document.querySelector('#arm-state.running') && parseFloat(document.querySelector('.play output').textContent) > 0.4);
  await new Promise((resolve) => setTimeout(resolve, (run * 17) % 50)); // anywhere in a frame
  const kind = run % 2 ? 'button' : 'script';
  let pressed_s;
  if (kind === 'script') {
    pressed_s = now_s();
    await fetch(`${origin}/api/arm/vent`, { method: 'POST', headers, body: '{}' });
  } else {
    const offset_s = now_s() - (await others[0].evaluate(() => performance.now())) / 1000; // at least: so times are not too short
    await others[0].bringToFront();
    const pressed_ms = await others[0].evaluate(() => {
      const at = performance.now();
      document.getElementById('vent').click();
      return at;
    });
    pressed_s = offset_s + pressed_ms / 1000;
  }
  await page.locator('#arm-panel').filter({ hasText: 'VENT was pressed' }).waitFor();
  const lines = readFileSync(log, 'utf8').trim().split('\n').map((line) => JSON.parse(line));
  const vented = lines.slice(lines.findIndex(({ event }) => event === 'set')).find(({ event }) => event === 'vent');
  times[kind].push(1000 * (vented.at_s - pressed_s));
}
loading = false;
await load;
for (const [kind, values] of Object.entries(times)) {
  console.log(`VENT by ${kind}: ${values.length} times, median ${quantile(values, 0.5).toFixed(1)} ms, 95 % ${quantile(values, 0.95).toFixed(1)} ms, at most ${Math.max(...values).toFixed(1)} ms`);
}
console.log('answers by status:', Object.fromEntries([...counts].sort()));
await browser.close();
await studio.stop();
