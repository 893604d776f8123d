// A report's charts: plain pictures without scripts, hovered and zoomed with them.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { program, root, startBrowser } from './studio.mjs';

test('a chart says what there is at the pointer, and is zoomed', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'limber_report_'));
  const browser = await startBrowser();
  try {
    const chart = join(folder, 'pressures.svg');
    execFileSync(program, ['plan', '--no-load', '--environment', '01_pillar', '--goal-margin-m', '0', '--margin-m', '0',
      '--max-queries', '20000', '--out', join(folder, 'plan.json'), '--pressures-svg', chart]);
    const script = readFileSync(join(root, 'web/dist/assets/report.js'), 'utf8');
    const file = join(folder, 'report.html');
    writeFileSync(file, `<!doctype html><meta charset="utf-8"><figure>${readFileSync(chart, 'utf8')}</figure><script>${script}</script>`);
    const page = await browser.newPage();
    const faults = [];
    page.on('pageerror', (error) => faults.push(String(error)));
    await page.goto(pathToFileURL(file).href);
    const box = await page.locator('svg[data-x] > rect').first().boundingBox();
    const at = (share) => [box.x + share * box.width, box.y + 0.5 * box.height];
    const note = () => page.locator('#moment').innerText();
    const time_s = async (share) => {
      await page.mouse.move(...at(share));
      return Number((await note()).split('\n')[0]);
    };
    const names = await page.locator('svg[data-x]').first().locator('path[data-name]').count();
    const [quarter, half] = [await time_s(0.25), await time_s(0.5)];
    assert.equal((await note()).split('\n').length, 1 + names);
    assert.ok(half > 1.9 * quarter && half < 2.1 * quarter, `${quarter} and ${half} s`);
    await page.mouse.move(...at(0.25));
    await page.mouse.down();
    await page.mouse.move(...at(0.5), { steps: 4 });
    await page.mouse.up();
    const left = await time_s(0.02);
    assert.ok(left > 0.98 * quarter && left < 1.1 * quarter, `from ${left} s on`);
    await page.mouse.dblclick(...at(0.5));
    assert.ok(Math.abs((await time_s(0.5)) - half) < 0.01 * half, 'all of it again');
    assert.deepEqual(faults, []);
  } finally {
    await browser.close();
    rmSync(folder, { recursive: true, force: true });
  }
});
