// What the page saves for others: pictures, and the animation, opened as its receiver does.

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after } from 'node:test';
import { pathToFileURL } from 'node:url';
import { openPlay, pageTest, serve, shared } from './page_test.mjs';
import { kPatience_ms } from './studio.mjs';

serve();
const kMost_bytes = 1_000_000;
const kPlanColour = [0x1f, 0x5f, 0xbf]; // --plan, light
// The file's numbers are whole units of 0.01 kPa and 0.1 mm, and a distance has two ends; what is
// printed is rounded once more. Lengths have two decimals, pressures one.
const kRounding = { kPa: 0.11, cm: 0.025 };
const isLength = (text) => /\.\d\d$/.test(text);
const folder = mkdtempSync(join(tmpdir(), 'limber_exports_'));
after(() => rmSync(folder, { recursive: true, force: true }));

/** What a button saves. */
async function saved(page, name) {
  const [download] = await Promise.all([
    page.waitForEvent('download'), page.getByRole('button', { name, exact: true }).click(),
  ]);
  const path = join(folder, download.suggestedFilename());
  await download.saveAs(path);
  return path;
}

/** A saved file from its folder, without a network. */
async function opened(path, options = {}) {
  const context = await shared.browser.newContext({ offline: true, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(kPatience_ms);
  page.faults = [];
  page.asked = [];
  page.on('pageerror', (error) => page.faults.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && page.faults.push(message.text()));
  page.on('request', (request) => page.asked.push(request.url()));
  await page.goto(pathToFileURL(path).href);
  return page;
}
/** Complaints, and requests for anything but the file itself. */
async function isAlone(page, path) {
  assert.deepEqual(page.faults, []);
  assert.deepEqual(page.asked, [pathToFileURL(path).href]);
  await page.context().close();
}

const stageSize = (page) => page.evaluate(() => {
  const { width, height } = document.getElementById('canvas').getBoundingClientRect();
  return [width, height];
});

pageTest('the PNG has twice the picture’s pixels, and the plan in its colour', async (page) => {
  const path = await saved(page, 'PNG');
  const [width, height] = await stageSize(page);
  const viewer = await opened(path);
  const image = await viewer.evaluate((colour) => {
    const picture = document.querySelector('img');
    const { naturalWidth: width, naturalHeight: height } = picture;
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    const context = canvas.getContext('2d');
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    let planned = 0;
    for (let i = 0; i < data.length; i += 4) {
      planned += colour.every((value, k) => Math.abs(data[i + k] - value) <= 2) ? 1 : 0;
    }
    return { width, height, planned };
  }, kPlanColour);
  assert.deepEqual([image.width, image.height], [2 * width, 2 * height]);
  assert.ok(image.planned > 1000, `${image.planned} pixels of the plan`);
  await viewer.context().close();
});

pageTest('the SVG is a drawing of the picture’s size that asks for nothing', async (page) => {
  const path = await saved(page, 'SVG');
  const [width, height] = await stageSize(page);
  const viewer = await opened(path);
  const drawing = await viewer.evaluate(() => {
    const { documentElement: root } = document;
    const box = root.getBoundingClientRect();
    const texts = [...root.querySelectorAll('text')].map((text) => text.textContent);
    return {
      tag: root.tagName, size: [box.width, box.height], texts,
      shapes: root.querySelectorAll('path, circle').length,
      active: root.querySelectorAll('script, image, use, foreignObject').length,
    };
  });
  assert.equal(drawing.tag, 'svg');
  assert.deepEqual(drawing.size, [width, height]);
  assert.equal(drawing.active, 0);
  assert.ok(drawing.shapes > 20, `${drawing.shapes} shapes`);
  assert.ok(drawing.texts.includes('0.2 m'), `the grid's numbers: ${drawing.texts}`);
  await isAlone(viewer, path);
});

pageTest('the animation plays from a file, and ends as the studio shows it', async (page) => {
  await openPlay(page);
  const path = await saved(page, 'One HTML file');
  assert.ok(statSync(path).size < kMost_bytes, `${statSync(path).size} bytes`);
  const token = new URL(shared.studio.address).searchParams.get('token');
  assert.ok(token && !readFileSync(path, 'utf8').includes(token), 'no token');

  const viewer = await opened(path);
  const slider = (of) => of.getByRole('slider', { name: 'Time in seconds' });
  const picture = () => viewer.locator('#stage').innerHTML();
  const numbers = (of) => of.locator('.plots figcaption b').allTextContents();
  const start = await picture();
  await slider(viewer).press('End');
  await slider(page).press('End');
  assert.notEqual(await picture(), start, 'the slider moves the arm');
  const [there, here] = [await numbers(viewer), await numbers(page)];
  assert.equal(there.length, here.length);
  there.forEach((text, i) => {
    const rounding = kRounding[isLength(text) ? 'cm' : 'kPa'];
    assert.ok(Math.abs(text - here[i]) < rounding, `${text} in the file, ${here[i]} in the studio`);
  });
  assert.deepEqual(await viewer.locator('.tracks small').allTextContents(),
    await page.locator('.tracks small').allTextContents());
  await slider(viewer).press('Home');
  assert.equal(await picture(), start);
  await viewer.getByRole('button', { name: 'Play' }).click();
  await viewer.waitForFunction(() => document.querySelector('.play input').valueAsNumber > 0.3);
  await viewer.getByRole('button', { name: 'Pause' }).click();
  assert.notEqual(await picture(), start, 'it plays');
  await isAlone(viewer, path);
});

pageTest('where scripts are off, the animation shows its picture and how it ends', async (page) => {
  await openPlay(page);
  const path = await saved(page, 'One HTML file');
  const viewer = await opened(path, { javaScriptEnabled: false });
  assert.ok(await viewer.locator('#stage > svg').isVisible());
  const words = await viewer.locator('#panel').innerText();
  assert.match(words, /Simple model: ends .*Virtual arm: ends .*(arrives|misses|strikes)/s);
  await isAlone(viewer, path);
});
