// A real arm behind a driver, as far as the page goes: the virtual arm's driver in its own process.

import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { network, openPage, program, root, startBrowser, startStudio } from './studio.mjs';

let studio;
let browser;
before(async () => {
  // A slow arm: its motions last long enough to be met by a browser on a busy machine. Its driver has two frames
  // to answer in, which a browser that draws in software takes from it at 20 frames per second.
  const arm = join(mkdtempSync(join(tmpdir(), 'limber_slow_arm_')), 'slow.yaml');
  const own = readFileSync(join(root, 'arms/three_segment.yaml'), 'utf8');
  writeFileSync(arm, own.replace(/pressure_rate_limit_kpa_per_s: \d+/, 'pressure_rate_limit_kpa_per_s: 12')
    .replace(/frame_rate_hz: \d+/, 'frame_rate_hz: 5'));
  studio = await startStudio('--arm', arm, '--driver', `exec:"${program}" virtual-arm --serve --arm "${arm}"`);
  browser = await startBrowser();
});
after(async () => {
  await browser?.close();
  assert.equal(await studio?.stop(), 0, 'Ctrl-C ends the studio');
});

const runs = () => (existsSync(join(studio.project, 'runs')) ? readdirSync(join(studio.project, 'runs')).sort() : []);
/** What the driver was told in the last run: time since its start, kind, set points. */
const told = () => {
  const log = runs().filter((name) => name.endsWith('.jsonl')).at(-1);
  return readFileSync(join(studio.project, 'runs', log), 'utf8').trim().split('\n').map((line) => JSON.parse(line))
    .filter((line) => line.to_driver)
    .map(({ to_driver }) => (typeof to_driver === 'string' ? JSON.parse(to_driver) : to_driver));
};

async function openPlay(address = studio.address) {
  const page = await openPage(browser, address);
  await page.waitForFunction(() => document.querySelector('.status.good') && !document.querySelector('.status em'));
  await page.getByRole('tab', { name: 'Play' }).click();
  await page.waitForSelector('.tracks');
  return page;
}
async function arm(page, percent) {
  await page.getByLabel(/Nobody is within its reach/).check();
  await page.getByRole('button', { name: 'Arm', exact: true }).click();
  await page.getByText('Armed.').waitFor();
  if (percent) await page.getByLabel(/limits that the arm may use/).selectOption({ label: `${percent} %` });
}
const play = (page) => page.getByRole('button', { name: 'Play on the arm' }).click();
const says = (page, words) => page.locator('#arm-panel').filter({ hasText: words }).waitFor();
const moving = (page) => page.waitForFunction(() =>
  document.querySelector('#arm-state.running') && parseFloat(document.querySelector('.play output').textContent) > 0.5);

test('armed by hand, the arm runs the plan within its limits, pauses, goes on and is recorded', async () => {
  const page = await openPlay();
  assert.ok(await page.getByRole('button', { name: 'Arm', exact: true }).isDisabled(), 'not before it is confirmed');
  await arm(page);
  await play(page);
  await says(page, /a limit scale of 0.1 allows.*Nothing was moved/s);
  await page.getByLabel(/limits that the arm may use/).selectOption({ label: '100 %' });
  await play(page);
  await moving(page);
  assert.ok(await page.getByLabel('Drop an obstacle').isDisabled(), 'it is as it was when the arm began');
  await page.getByRole('button', { name: 'Pause' }).dispatchEvent('click');
  await says(page, 'Holds: paused');
  await page.waitForTimeout(1000); // five frames: a fast page would go on before three are over
  await page.getByRole('tab', { name: 'Follow' }).click();
  await page.getByRole('tab', { name: 'Play' }).click(); // its run is not lost by that
  await page.getByRole('button', { name: 'Go on' }).click();
  await says(page, /vented: .* kPa/);
  assert.match(await page.textContent('.tracks'), /Simple model.*The arm.*(arrives|misses|strikes)/s);
  await says(page, /Recorded: runs\/run_.*\.h5/);
  const sets = told().filter(({ type }) => type === 'set').map(({ pressure_kpa }) => String(pressure_kpa));
  const held = sets.filter((set, k) => k > 0 && set === sets[k - 1] && k < sets.length - 20).length;
  assert.ok(held >= 3, 'while paused, the last set points are sent again');
  await page.getByRole('button', { name: 'Disarm' }).click();
  await page.getByRole('button', { name: 'Arm', exact: true }).waitFor();
  await page.context().close();
});

for (const [name, press] of [
  ['the VENT button of another page', async (page, other) => other.getByRole('button', { name: 'VENT' }).click()],
  ['the VENT button before it is let go', async (page) => page.getByRole('button', { name: 'VENT' }).dispatchEvent('pointerdown')],
  ['Space', (page) => page.keyboard.press('Space')],
  ['Escape', (page) => page.keyboard.press('Escape')],
  ['Escape on another page', (page, other) => other.keyboard.press('Escape')],
]) {
  test(`${name} vents a moving arm, and disarms it`, async () => {
    const [page, other] = [await openPlay(), await openPage(browser, studio.address)];
    await arm(page, 100);
    await play(page);
    await moving(page);
    await press(page, other);
    await says(page, /VENT was pressed; vented: .* kPa/);
    await page.getByRole('button', { name: 'Arm', exact: true }).waitFor();
    assert.equal(told().at(-1).type, 'bye');
    for (const one of [page, other]) {
      assert.deepEqual(one.faults, []);
      await one.context().close();
    }
  });
}

test('stopped, the arm is vented and stays armed', async () => {
  const page = await openPlay();
  await arm(page, 100);
  await play(page);
  await moving(page);
  await page.getByRole('button', { name: 'Stop' }).dispatchEvent('click');
  await says(page, /stopped by hand; vented: .* kPa/);
  await page.getByText('Armed.').waitFor();
  await page.context().close();
});

test('a page whose own timers stand still keeps its lease, one that is gone loses it', async () => {
  const page = await openPlay();
  await arm(page, 100);
  await page.evaluate(() => {
    for (const end = performance.now() + 4000; performance.now() < end; );
  });
  await play(page);
  await moving(page);
  await page.context().close();
  const other = await openPlay();
  await other.locator('#arm-panel').filter({ hasText: 'not heard for 3 s; vented' }).waitFor();
  const sets = told().filter(({ type }) => type === 'set');
  const last = sets.at(-1);
  const held = sets.filter(({ pressure_kpa }) => String(pressure_kpa) === String(last.pressure_kpa));
  assert.ok(Math.abs(last.t - held[0].t - 2) < 0.5, `held from 1 s to 3 s: ${last.t - held[0].t} s`);
  await other.context().close();
});

test('closed loop, with an obstacle dropped into its way, on the arm', async () => {
  const quick = await startStudio('--model', network, '--driver', `exec:"${program}" virtual-arm --serve`);
  const page = await openPlay(quick.address);
  await page.getByLabel('Closed loop').check();
  await page.getByLabel('Drop an obstacle').check();
  await page.locator('.tracks li').nth(2).waitFor();
  await arm(page, 100);
  await play(page);
  await page.waitForFunction(() => document.querySelector('#arm-panel .status'));
  await says(page, /vented: .* kPa/);
  assert.match(await page.textContent('.tracks'), /The arm/);
  assert.deepEqual(page.faults, []);
  await page.context().close();
  assert.equal(await quick.stop(), 0);
});
