// From the pointer event to the first painted certified plan, in real Chromium:
//   node tests/measure.mjs [POSITIONS] [MODEL.safetensors]
// In each of the eight environments the goal, without a heading, is dragged to POSITIONS places, drawn with a fixed seed from the
// cells that the arm reaches. Places without a plan after 5 s are counted apart, with when their reason stood there.

import { network, openPage, pixelsOf, startBrowser, startStudio } from './studio.mjs';

const positions = Number(process.argv[2] ?? 200);
const model = process.argv[3] ?? network;
const kSeed = 45;
const kPatience_ms = 12000;
const environments = [
  '01_pillar', '02_two_pillars', '03_gap_in_a_wall', '04_reach_behind', '05_between_pillars',
  '06_overshoot', '07_clutter', '08_overshoot_in_clutter',
];

/** mulberry32: numbers in [0, 1), the same everywhere. */
function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

const quantile = (values, share) => {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted.length ? sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] : NaN;
};
const line = (name, painted, reasons) =>
  console.log(`${name.padEnd(24)} ${painted.length} painted: median ${quantile(painted, 0.5).toFixed(0)} ms, 95 % ${quantile(painted, 0.95).toFixed(0)} ms; ` +
    `${reasons.length} without a plan, reason after ${quantile(reasons, 0.5).toFixed(0)} ms in the median, ${quantile(reasons, 1).toFixed(0)} at most`);

const studio = await startStudio('--model', model);
const browser = await startBrowser();
const all = { painted: [], reasons: [] };
for (const environment of environments) {
  const page = await openPage(browser, studio.address);
  await page.getByLabel('Seconds to search for').selectOption('5');
  await page.locator('.field', { hasText: /^Environment/ }).locator('select').selectOption(`limber:${environment}`);
  await page.waitForFunction((name) => decodeURIComponent(location.hash).includes(name), environment);
  await page.getByRole('button', { name: 'Goal', exact: true }).click();
  await page.getByLabel('with a heading').setChecked(false);
  await page.waitForSelector('.status.good, .status.bad');
  const { middles_m } = await page.evaluate(async () => (await (await fetch('/api/arm?name=limber:three_segment')).json()).reach);
  const random = randomNumbers(kSeed);
  const field = (name) => page.locator('.field', { hasText: name }).locator('input').first().inputValue().then(Number);
  const at = [await field(/^x/), await field(/^y/)];
  await page.mouse.move(...(await pixelsOf(page, at)));
  await page.mouse.down();
  const painted = [];
  const reasons = [];
  for (let i = 0; i < positions; ++i) {
    const cell = 2 * Math.floor((random() * middles_m.length) / 2);
    await page.evaluate(() => {
      performance.clearMeasures();
      window.reasonAt_ms = undefined;
      window.movedAt_ms = performance.now();
      // Until the page renews it, what stands there was said of the place before.
      window.isOld = true;
      window.watch ??= new MutationObserver(() => { window.isOld = false; });
      window.watch.observe(document.querySelector('#status'), { childList: true });
    });
    await page.mouse.move(...(await pixelsOf(page, [middles_m[cell], middles_m[cell + 1]])));
    const took = await page
      .waitForFunction(() => {
        const found = performance.getEntriesByType('measure')[0];
        const isOver = !window.isOld && document.querySelector('.status.bad') !== null;
        // The first sentence that says why not, while it still searches or at the end.
        if (isOver || (!window.isOld && document.querySelector('.status.busy p'))) window.reasonAt_ms ??= performance.now();
        return found ? { painted: found.duration } : isOver ? { reason: window.reasonAt_ms - window.movedAt_ms } : false;
      }, null, { timeout: kPatience_ms, polling: 'raf' })
      .then((handle) => handle.jsonValue());
    if (took.painted !== undefined) painted.push(took.painted);
    else reasons.push(took.reason);
  }
  await page.mouse.up();
  await page.context().close();
  line(environment, painted, reasons);
  all.painted.push(...painted);
  all.reasons.push(...reasons);
}
line('all', all.painted, all.reasons);
await browser.close();
await studio.stop();
