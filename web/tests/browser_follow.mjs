// A path drawn by hand, followed by the virtual arm; and what is saved of it, followed by the program.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pageTest, serve, shared } from './page_test.mjs';
import { network, pixelsOf, program } from './studio.mjs';

serve();
const outcome = (page) => page.getByText(/off the path by [\d.]+ cm/);
const followed = (page) => outcome(page).waitFor();
const rms_cm = async (page) => Number((await outcome(page).textContent()).match(/off the path by ([\d.]+) cm/)[1]);

pageTest('a path is drawn by hand, and the arm follows it', async (page) => {
  await page.getByRole('tab', { name: 'Follow' }).click();
  await page.getByText('There is no path yet').waitFor();
  await page.getByLabel('Takes').selectOption('10');
  await page.mouse.move(...(await pixelsOf(page, [0.42, 0.25])));
  await page.mouse.down();
  for (const point of [[0.4, 0.3], [0.36, 0.35], [0.32, 0.38]]) await page.mouse.move(...(await pixelsOf(page, point)), { steps: 5 });
  await page.mouse.up();
  await followed(page);
  assert.ok((await rms_cm(page)) < 1.5, await outcome(page).textContent());
  assert.match(await page.textContent('.plots'), /Pressure of segment 2.*Tip from the path.*Clearance/s);
  await page.waitForFunction(() => document.querySelector('.play input').valueAsNumber > 0.3);
  const before = await outcome(page).textContent();
  await page.mouse.click(...(await pixelsOf(page, [0.5, 0.1])));
  assert.equal(await outcome(page).textContent(), before, 'a tap draws nothing');
});

pageTest('a circle is followed by keyboard alone, and its file by the program', async (page) => {
  await page.getByRole('tab', { name: 'Follow' }).press('Enter');
  await page.getByLabel('Takes').selectOption('10');
  await page.getByRole('button', { name: 'Circle' }).press('Enter');
  await followed(page);
  assert.ok((await rms_cm(page)) < 1.5, await outcome(page).textContent());
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'CSV' }).press('Enter')]);
  const file = join(shared.studio.project, 'path.csv');
  await download.saveAs(file);
  assert.match(readFileSync(file, 'utf8'), /^time_s,x_m,y_m\n0\.0000,/);
  execFileSync(program, ['execute', '--track', file, '--model', network, '--quiet']);
});

pageTest('pictures are saved from Follow and Drive too', async (page) => {
  for (const name of ['Follow', 'Drive']) {
    await page.getByRole('tab', { name }).click();
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'SVG' }).click()]);
    assert.match(download.suggestedFilename(), /\.svg$/);
  }
});

pageTest('a path that leaves the arm’s reach is refused in words', async (page) => {
  await page.getByRole('tab', { name: 'Follow' }).click();
  await page.mouse.move(...(await pixelsOf(page, [0.75, 0.2])));
  await page.mouse.down();
  await page.mouse.move(...(await pixelsOf(page, [0.75, -0.2])), { steps: 5 });
  await page.mouse.up();
  await page.getByText(/is 0\.\d+ m from the base; the arm is/).waitFor();
});
