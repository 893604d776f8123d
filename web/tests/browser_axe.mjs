// No violation of what axe-core knows about accessible pages, in each mode, light and dark, on a
// desk and on a phone.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { openPlay, pageTest, serve, shared } from './page_test.mjs';
import { makeResults } from './results_folder.mjs';
import { program } from './studio.mjs';

shared.prepare = makeResults;
serve('--driver', `exec:"${program}" virtual-arm --serve`);
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const kRules = 30; // of those that axe-core has, at least so many find something to look at

async function violationsOf(page) {
  await page.evaluate(axe); // beside the page's own rules for scripts
  const { violations, passes } = await page.evaluate(() => globalThis.axe.run(document));
  assert.ok(passes.length >= kRules, `only ${passes.length} rules were looked at`);
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(({ html, failureSummary }) => `${id}: ${html} ${failureSummary}`));
}
/** @param what  of the page, for whoever reads a failure */
async function isAccessible(page, what) {
  assert.deepEqual(await violationsOf(page), [], what);
}
const idle = (page) => page.waitForFunction(() =>
  document.querySelector('.status') && !document.querySelector('.status em, .status.busy'));
const press = (page, name) => page.getByRole('button', { name, exact: true }).click();

async function plan(page) {
  await idle(page);
  await isAccessible(page, 'a certified plan');
  for (const kind of ['circle', 'polygon', 'rectangle']) {
    await press(page, `Add a ${kind}`);
    await idle(page);
    await isAccessible(page, `a ${kind} is selected`);
    await press(page, 'Delete');
  }
  await press(page, 'Goal');
  await page.getByLabel('with a heading').check();
  await idle(page);
  await isAccessible(page, 'the goal is selected');
  await press(page, 'Copy link');
  await page.getByText('restores the scene').waitFor();
  await isAccessible(page, 'a notice');
  await page.locator('.field', { hasText: /^x/ }).locator('input').fill('3');
  await page.locator('.field', { hasText: /^x/ }).locator('input').press('Enter');
  await page.waitForSelector('.status.bad');
  await isAccessible(page, 'no plan');
  await page.getByRole('tab', { name: 'Play' }).click();
  await page.getByText('There is no certified plan').waitFor();
  await isAccessible(page, 'nothing to play');
}

async function play(page) {
  await idle(page);
  await openPlay(page);
  await isAccessible(page, 'Play');
  await page.getByLabel(/Nobody is within its reach/).check();
  await isAccessible(page, 'confirmed');
  await press(page, 'Arm');
  await page.getByText('Armed.').waitFor();
  await isAccessible(page, 'armed');
  await press(page, 'VENT');
  await page.locator('#arm-panel').filter({ hasText: 'VENT was pressed' }).waitFor();
  await isAccessible(page, 'vented');
}

async function follow(page) {
  await page.getByRole('tab', { name: 'Follow' }).click();
  await page.getByText('There is no path yet').waitFor();
  await isAccessible(page, 'Follow, empty');
  await press(page, 'Eight');
  await page.getByText(/off the path by/).waitFor();
  await isAccessible(page, 'Follow');
}

async function drive(page) {
  await page.getByRole('tab', { name: 'Drive' }).click();
  await page.getByRole('slider', { name: /Segment 0/ }).press('End');
  await page.waitForSelector('#readout dt');
  await isAccessible(page, 'Drive');
}

async function results(page) {
  await page.getByRole('tab', { name: 'Results' }).click();
  await page.locator('.experiment [aria-expanded]').first().click();
  await page.waitForSelector('.runs button');
  await press(page, 'Measure');
  await page.waitForSelector('#measured .maps');
  await isAccessible(page, 'an experiment, its runs, errors and coverage');
}

async function family(page) {
  await page.getByLabel('Model').selectOption('limber:three_segment_small');
  await page.locator('.status', { hasText: 'A family of arms' }).waitFor();
  await page.getByRole('tab', { name: 'Drive' }).click();
  await page.getByRole('button', { name: /The numbers behind it/ }).click();
  await page.waitForSelector('#readout dt');
  await isAccessible(page, 'the arms of a family');
}

pageTest('a nameless button and pale words would be found', async (page) => {
  await page.evaluate(() => {
    const pale = Object.assign(document.createElement('p'), { textContent: 'pale' });
    pale.style.color = '#ccc';
    document.getElementById('panel').prepend(document.createElement('button'), pale);
  });
  const found = (await violationsOf(page)).map((text) => text.split(':')[0]).sort();
  assert.deepEqual(found, ['button-name', 'color-contrast']);
});

const sizes = { desk: { width: 1280, height: 800 }, phone: { width: 390, height: 844 } };
for (const [size, viewport] of Object.entries(sizes)) {
  for (const colorScheme of ['light', 'dark']) {
    for (const mode of [plan, play, follow, drive, results, family]) {
      pageTest(`${mode.name}, ${colorScheme}, on a ${size}`, mode, { viewport, colorScheme });
    }
  }
}
