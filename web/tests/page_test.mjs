// Tests of a page in Debian's Chromium, one studio and one browser for all of a file.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { network, openPage, startBrowser, startStudio } from './studio.mjs';

export const shared = {}; // `studio` and `browser`, while tests run; `prepare`, what a project folder gets first

/** The network's studio for all tests of a file. @param flags  further ones of `limber studio` */
export function serve(...flags) {
  before(async () => {
    shared.studio = await startStudio('--model', network, ...flags);
    shared.prepare?.(shared.studio.project);
    shared.browser = await startBrowser();
  });
  after(async () => {
    await shared.browser?.close();
    assert.equal(await shared.studio?.stop(), 0, 'Ctrl-C ends the studio');
  });
}

/** A test with a page of its own, which must not complain. */
export function pageTest(name, use, options) {
  test(name, async () => {
    const page = await openPage(shared.browser, shared.studio.address, options);
    try {
      await page.waitForSelector('.status.good');
      await use(page);
      assert.deepEqual(page.faults, []);
    } finally {
      await page.context().close(); // four tabs can be open at once
    }
  });
}

/** Play, at rest where the motion begins; by both models and the virtual arm. */
export async function openPlay(page) {
  await page.getByRole('tab', { name: 'Play' }).click();
  await page.waitForSelector('.tracks');
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.getByRole('slider', { name: 'Time in seconds' }).press('Home');
}
