// What was made before: an experiment's runs, errors on a recording, and the arms of a family.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { pageTest, serve, shared } from './page_test.mjs';
import { makeResults } from './results_folder.mjs';
import { network, program } from './studio.mjs';

shared.prepare = makeResults;
serve();

const results = async (page) => {
  await page.getByRole('tab', { name: 'Results' }).click();
  await page.waitForSelector('.experiment');
};

pageTest('a run of the last experiment is opened from its row, and played', async (page) => {
  await page.getByRole('tab', { name: 'Play' }).click();
  await page.getByLabel('Closed loop').check();
  await page.getByRole('tab', { name: 'Plan', exact: true }).click();
  await page.getByLabel('Model').selectOption('');
  await results(page);
  assert.match(await page.textContent('#panel'), /results\/table/);
  const rows = page.locator('.experiment [aria-expanded]');
  assert.equal(await rows.count(), 2, 'the simple model and the network');
  const mine = page.locator('.experiment tr', { hasText: 'network' }).locator('[aria-expanded]');
  await mine.press('Enter');
  await page.waitForSelector('.runs button');
  assert.equal(await page.locator('.runs button').count(), 2);
  assert.match(await page.locator('.runs button').first().textContent(), /0 · (arrives|misses|collides), \d\.\d\d cm/);
  await page.locator('.runs button').last().press('Enter');
  await page.waitForSelector('.tracks li');
  assert.equal(await page.getByRole('tab', { name: 'Play' }).getAttribute('aria-selected'), 'true');
  assert.match(await page.textContent('.tracks'), /Simple model.*Network.*Virtual arm/s);
  assert.equal(await page.getByLabel('Closed loop').isChecked(), false, 'as the row was executed');
  assert.match(decodeURIComponent(page.url()), /model=(given|models).*environments\/01_pillar/);
  await page.getByRole('tab', { name: 'Plan', exact: true }).click();
  assert.match(await page.textContent('.status.good'), /Certified plan/);
});

pageTest('the model is measured on a recording, and what that covers is drawn', async (page) => {
  await page.getByRole('tab', { name: 'Results' }).click();
  await page.getByLabel('Recording').selectOption('recordings/six.h5');
  await page.getByRole('button', { name: 'Measure' }).press('Enter');
  await page.waitForSelector('#measured .maps');
  assert.equal(await page.locator('.maps figure').count(), 3, 'three pairs of segments');
  const shown = await page.locator('#measured table').innerText();
  const said = JSON.parse(execFileSync(program, ['evaluate', '--json', '--model', network,
    '--data', join(shared.studio.project, 'recordings/six.h5')]));
  const { tip_error_cm } = said.horizons;
  for (const [key, name] of [['network', 'Network'], ['no_load', 'Simple model'], ['hold', 'Hold the pose']]) {
    const ends = [tip_error_cm[key][0], tip_error_cm[key].at(-1)].map((cm) => cm.toFixed(2));
    assert.match(shown, new RegExp(`${name}\\s+${ends[0]}\\s+${ends[1]}`), `${key}: as limber evaluate says`);
  }
  await page.getByRole('button', { name: 'Measure' }).press('Enter');
  await page.getByRole('button', { name: 'Stop' }).click({ force: true }); // or it has just ended
  await page.waitForFunction(() => document.querySelector('progress').hidden);
});

pageTest('a family is fitted to the virtual arm, and plans', async (page) => {
  page.setDefaultTimeout(180_000); // a minute of motion and its fit, on a busy machine
  await page.getByLabel('Model').selectOption('limber:three_segment_small');
  await page.getByRole('button', { name: 'Fit it to the virtual arm' }).click();
  await page.locator('#panel').getByText('Certified plan', { exact: false }).waitFor();
  assert.match(await page.getByLabel('Model').inputValue(), /^models\/three_segment_fitted.*safetensors$/);
  assert.match(await page.textContent('#notice'), /cm off on seconds that it had not seen/);
});

pageTest('what a family’s arms differ in moves its network at once; it is not planned with', async (page) => {
  await page.getByLabel('Model').selectOption('limber:three_segment_small');
  await page.locator('.status', { hasText: 'A family of arms' }).waitFor();
  await page.getByRole('tab', { name: 'Drive' }).click();
  await page.waitForSelector('#family');
  assert.equal(await page.locator('#family input').count(), 8);
  await page.getByText('The virtual arm stays as it is').waitFor();
  await page.getByRole('slider', { name: /friction on the table, of the arm file 0\.250/ }).waitFor();
  const numbers = page.getByRole('button', { name: 'The numbers behind it: 12' });
  await numbers.press('Enter');
  assert.equal(await page.locator('#family input').count(), 12);
  await page.getByRole('button', { name: 'What they tell of' }).press('Enter');
  await page.getByRole('slider', { name: /Segment 0/ }).press('End');
  const away = () => page.evaluate(() => {
    const names = [...document.querySelectorAll('#readout dt')];
    return names.find((dt) => dt.textContent === 'Network')?.nextElementSibling.textContent ?? '';
  });
  // Three readings a second apart are alike.
  const settled = async () => {
    let reading = '';
    for (let alike = 0; alike < 2; ) {
      await page.waitForTimeout(1000);
      const now = await away();
      alike = now === reading && now !== '' ? alike + 1 : 0;
      reading = now;
    }
    return reading;
  };
  const middle = await settled();
  await page.getByRole('slider', { name: /friction on the table/ }).press('PageUp');
  const rougher = await settled();
  assert.notEqual(rougher, middle, 'on a rougher table it stands elsewhere');
  await numbers.press('Enter');
  assert.notEqual(await page.getByRole('slider', { name: /Number 0 / }).inputValue(), '0');
  await page.getByRole('slider', { name: /Number 0 / }).press('End');
  await page.getByRole('slider', { name: /Number 1 / }).press('End');
  assert.notEqual(await settled(), rougher, 'and another arm elsewhere again');
  await page.getByRole('button', { name: 'The family’s middle' }).click();
  assert.equal(await settled(), middle, 'and the middle where it was');
});
