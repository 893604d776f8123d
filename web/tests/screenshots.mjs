// The pictures of docs/studio.md, and the same in dark and on a phone, to look at:
//   node tests/screenshots.mjs FOLDER

import { delimiter, dirname, join } from 'node:path';
import { makeResults } from './results_folder.mjs';
import { drag, network, openPage, program, startBrowser, startStudio } from './studio.mjs';

const folder = process.argv[2];
const looks = {
  '': {},
  _dark: { colorScheme: 'dark' },
  _phone: { viewport: { width: 390, height: 844 }, hasTouch: true },
  _phone_dark: { viewport: { width: 390, height: 844 }, hasTouch: true, colorScheme: 'dark' },
};
process.env.PATH = `${dirname(program)}${delimiter}${process.env.PATH}`; // no folder of this machine in a picture
const studio = await startStudio('--model', network, '--driver', 'exec:limber virtual-arm --serve');
makeResults(studio.project);
const browser = await startBrowser();
for (const [look, options] of Object.entries(looks)) {
  const page = await openPage(browser, studio.address, options);
  const shot = (name) => page.screenshot({ path: join(folder, `studio_${name}${look}.png`) });
  const idle = () => page.waitForFunction(() => document.querySelector('.status.good') && !document.querySelector('.status em'));
  await page.locator('.field', { hasText: /^Environment/ }).locator('select').selectOption('limber:05_between_pillars');
  await page.getByLabel('Search tree').check();
  await page.getByRole('button', { name: 'Goal', exact: true }).click();
  await idle();
  await shot('plan');
  await page.getByRole('tab', { name: 'Play' }).click();
  await page.waitForSelector('.tracks');
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  await shot('play');
  await page.getByLabel('Nobody is within its reach').check();
  await page.getByRole('button', { name: 'Arm', exact: true }).click();
  await page.getByLabel('limits that the arm may use').selectOption({ label: '100 %' });
  await shot('armed');
  await page.getByRole('button', { name: 'Play on the arm' }).click();
  await page.waitForFunction(() => document.querySelector('#arm-state.running') && parseFloat(document.querySelector('.play output').textContent) > 1.5);
  await shot('arm');
  await page.getByRole('button', { name: 'VENT' }).click();
  await page.locator('#arm-panel').filter({ hasText: 'VENT was pressed' }).waitFor();
  await shot('vented');
  await page.getByRole('tab', { name: 'Plan' }).click();
  await page.locator('.field', { hasText: /^Environment/ }).locator('select').selectOption('limber:01_pillar');
  await idle();
  await page.getByRole('tab', { name: 'Follow' }).click();
  await page.getByRole('button', { name: 'Eight' }).click();
  await page.waitForFunction(() => document.body.textContent.includes('off the path by') && document.querySelector('.play input').valueAsNumber > 9);
  await shot('follow');
  await page.getByRole('tab', { name: 'Drive' }).click();
  const slide = async (segment, key) => {
    await page.getByRole('slider', { name: new RegExp(`Segment ${segment}`) }).focus();
    await page.keyboard.press(key);
  };
  const settled = async () => {
    for (let last = '', now = 'x'; last !== now || now === ''; ) {
      last = now;
      await page.waitForTimeout(3500);
      now = await page.textContent('#readout');
    }
  };
  await slide(0, 'End');
  await slide(1, 'End');
  await settled();
  await page.getByRole('button', { name: 'All to zero' }).click();
  await settled();
  await shot('drive');
  await page.getByRole('tab', { name: 'Results' }).click();
  await page.locator('.experiment [aria-expanded]').nth(1).click();
  await page.waitForSelector('.runs button');
  await page.getByRole('button', { name: 'Measure' }).click();
  await page.waitForSelector('#measured .maps');
  await shot('results');
  await page.locator('#panel').evaluate((panel) => panel.scrollTo(0, 1e6));
  await shot('measured');
  await page.getByRole('tab', { name: 'Plan', exact: true }).click();
  await page.getByLabel('Model').selectOption('limber:three_segment_small');
  await page.getByRole('tab', { name: 'Drive' }).click();
  await page.waitForSelector('#family');
  await slide(0, 'End');
  await page.getByRole('slider', { name: /friction on the table/ }).press('Home');
  await page.waitForTimeout(2500);
  await shot('family');
  if (look === '') {
    await page.getByRole('tab', { name: 'Plan', exact: true }).click();
    await page.getByLabel('Plan while dragging').uncheck();
    await page.getByRole('button', { name: 'Add a rectangle' }).click();
    await drag(page, [0.4, 0.2], [0.42, 0.22]);
    await shot('edit');
  }
  await page.context().close();
}
await browser.close();
await studio.stop();
