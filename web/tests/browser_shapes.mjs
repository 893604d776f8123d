// The page of an arm in space: turned by keys, mouse and finger, with nothing loaded, and accessible.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { program, startBrowser } from './studio.mjs';

const folder = mkdtempSync(join(tmpdir(), 'limber_shapes_'));
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
let browser;
before(async () => {
  const recording = join(folder, 'test.h5');
  const arm = ['--arm', 'hanging_3x2'];
  execFileSync(program, ['collect', ...arm, '--schedule', 'random', '--count', '5', '--out', recording], { stdio: 'ignore' });
  execFileSync(program, ['evaluate', ...arm, '--data', recording, '--plots', join(folder, 'plots')], { stdio: 'ignore' });
  browser = await startBrowser();
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

async function open(options = {}) {
  const page = await (await browser.newContext(options)).newPage();
  page.faults = [];
  page.on('pageerror', (error) => page.faults.push(String(error)));
  page.on('request', (request) => request.url().startsWith('http') && page.faults.push(request.url()));
  await page.goto(pathToFileURL(join(folder, 'plots/shapes.html')).href);
  return page;
}
const drawn = (page) => page.locator('canvas').evaluate((canvas) => canvas.toDataURL());

/** Does something, after which the arm looks other than before. */
async function changes(page, what, act) {
  const before = await drawn(page);
  await act();
  assert.notEqual(await drawn(page), before, what);
}

test('keys, mouse, buttons and time change what is seen', async () => {
  const page = await open();
  await page.locator('canvas').focus();
  const start = await drawn(page);
  for (const key of ['ArrowLeft', 'ArrowUp', '+', 'ArrowRight', 'ArrowDown', '-']) {
    await changes(page, key, () => page.keyboard.press(key));
  }
  await page.keyboard.press('Home');
  assert.equal(await drawn(page), start);
  await changes(page, 'drag', async () => {
    await page.mouse.move(300, 300);
    await page.mouse.down();
    await page.mouse.move(360, 320);
    await page.mouse.up();
  });
  await changes(page, 'wheel', () => page.mouse.wheel(0, 200));
  for (const name of ['Above', 'Side', 'Front']) {
    await changes(page, name, () => page.getByRole('button', { name }).click());
  }
  const slider = page.getByRole('slider', { name: 'Time in seconds' });
  await changes(page, 'time', () => slider.press('Home'));
  await slider.press('End');
  const off = page.locator('.shapes output').nth(1);
  assert.match(await off.innerText(), /^\d+\.\d mm$/);
  await changes(page, 'what is shown', () => page.getByRole('checkbox', { name: 'no load' }).uncheck());
  assert.deepEqual(page.faults, []);
});

for (const colorScheme of ['light', 'dark']) {
  test(`a phone, ${colorScheme}: turned by a finger, and accessible`, async () => {
    const page = await open({ colorScheme, viewport: { width: 390, height: 844 }, hasTouch: true });
    const finger = (type, x, y) => page.locator('canvas').dispatchEvent(type, { pointerId: 7, pointerType: 'touch', clientX: x, clientY: y });
    await page.locator('canvas').evaluate((canvas) => { canvas.setPointerCapture = () => {}; });
    await changes(page, 'finger', async () => {
      await finger('pointerdown', 100, 200);
      await finger('pointermove', 160, 200);
      await finger('pointerup', 160, 200);
    });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => globalThis.axe.run(document));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), []);
    assert.deepEqual(page.faults, []);
  });
}
