// How soon the page is ready, how even playback is, and what a long drag and many requests leave behind:
//   node tests/measure_page.mjs [MINUTES OF DRAGGING]

import { readFileSync } from 'node:fs';
import { network, openPage, pixelsOf, startBrowser, startStudio } from './studio.mjs';

const minutes = Number(process.argv[2] ?? 10);
const kRequests_per_s = 200;
const kSeconds = 60;

const studio = await startStudio('--model', network);
const browser = await startBrowser();
const server_MB = () => Number(readFileSync(`/proc/${studio.pid}/status`, 'utf8').match(/VmRSS:\s+(\d+)/)[1]) / 1024;
const quantile = (values, share) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];

const page = await openPage(browser, studio.address);
const ready = await page.evaluate(() => {
  const [{ domContentLoadedEventEnd, responseStart }] = performance.getEntriesByType('navigation');
  return { loaded_ms: domContentLoadedEventEnd - responseStart };
});
await page.reload();
await page.waitForSelector('.status.good');
const first_ms = await page.evaluate(() => performance.getEntriesByType('measure')[0]?.startTime ?? performance.now());
console.log(`ready: scripts run after ${ready.loaded_ms.toFixed(0)} ms, the first plan is asked for after ${first_ms.toFixed(0)} ms`);

await page.locator('.field', { hasText: /^Environment/ }).locator('select').selectOption('limber:08_overshoot_in_clutter');
await page.getByLabel('Search tree').check();
await page.getByRole('button', { name: 'Plan', exact: true }).click();
await page.waitForFunction(() => document.querySelector('.status.good') && !document.querySelector('.status em'));
await page.getByRole('tab', { name: 'Play' }).click();
await page.waitForSelector('.tracks');
const gaps = await page.evaluate(async () => {
  const result = [];
  let last = performance.now();
  while (result.length < 100) {
    const now = await new Promise((resolve) => requestAnimationFrame(resolve));
    const press = document.querySelector('.play .main');
    if (press.textContent === 'Play') press.click();
    result.push(now - last);
    last = now;
  }
  return result.slice(5);
});
console.log(`playback with the tree: frame gaps ${quantile(gaps, 0.5).toFixed(1)} ms in the median, ${quantile(gaps, 0.95).toFixed(1)} ms for 95 %`);

await page.getByRole('tab', { name: 'Plan' }).click();
await page.getByRole('button', { name: 'Goal', exact: true }).click();
const session = await page.context().newCDPSession(page);
const page_MB = async () => {
  await session.send('HeapProfiler.collectGarbage');
  return (await session.send('Runtime.getHeapUsage')).usedSize / 1e6;
};
const goal = [0.35, -0.3];
const field = (name) => page.locator('.field', { hasText: name }).locator('input').first().inputValue().then(Number);
await page.mouse.move(...(await pixelsOf(page, [await field(/^x/), await field(/^y/)])));
await page.mouse.down();
const begin = performance.now();
for (let minute = 0, k = 0; minute <= minutes; ) {
  const turn = 0.05 * k++;
  await page.mouse.move(...(await pixelsOf(page, [goal[0] + 0.1 * Math.cos(turn), goal[1] + 0.1 * Math.sin(turn)])));
  if (performance.now() - begin >= 60000 * minute) {
    console.log(`dragging, ${minute} min: page ${(await page_MB()).toFixed(1)} MB, server ${server_MB().toFixed(0)} MB`);
    ++minute;
  }
}
await page.mouse.up();
await browser.close();

const { origin } = new URL(studio.address);
const Cookie = (await fetch(studio.address, { redirect: 'manual' })).headers.get('set-cookie').split(';')[0];
const headers = { Cookie, Origin: origin, 'Content-Type': 'application/json' };
const kinds = [
  ['GET', '/api/project', 200], ['GET', '/api/arm?name=limber:three_segment', 200], ['GET', '/assets/studio.css', 200],
  ['POST', '/api/stop', 400, '{'], ['POST', '/api/drive', 400, '{}'], ['GET', '/nothing', 404],
];
const counts = {};
const before_MB = server_MB();
for (let k = 0; k < kRequests_per_s * kSeconds; ++k) {
  const [method, path, wanted, body] = kinds[k % kinds.length];
  const count = (what) => (counts[what] = (counts[what] ?? 0) + 1);
  fetch(origin + path, { method, headers, body })
    .then((answer) => answer.arrayBuffer().then(() => count(answer.status === wanted ? 'as meant' : `${path} ${answer.status}`)))
    .catch(() => count('lost'));
  await new Promise((resolve) => setTimeout(resolve, 1000 / kRequests_per_s));
}
await new Promise((resolve) => setTimeout(resolve, 3000));
console.log(`${kRequests_per_s} requests per second for ${kSeconds} s:`, JSON.stringify(counts), `server ${before_MB.toFixed(0)} MB before, ${server_MB().toFixed(0)} MB after`);
await studio.stop();
