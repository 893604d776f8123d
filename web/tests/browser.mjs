// Every feature of the page, in Debian's Chromium against the real program.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pageTest, serve, shared } from './page_test.mjs';
import { drag, fieldValue, network, openPage, pixelsOf, program, root } from './studio.mjs';

serve();
const certified = (page) => page.waitForSelector('.status.good');
const select = (page, name) => page.getByRole('button', { name, exact: true }).click();
const goal = [0.512, 0.331];

async function placeGoal(page, [x, y]) {
  await select(page, 'Goal');
  await page.locator('.field', { hasText: /^x/ }).locator('input').fill(String(x));
  await page.locator('.field', { hasText: /^x/ }).locator('input').press('Enter');
  await page.locator('.field', { hasText: /^y/ }).locator('input').fill(String(y));
  await page.locator('.field', { hasText: /^y/ }).locator('input').press('Enter');
}

pageTest('a plan is certified as soon as the page is open', async (page) => {
  assert.match(await page.textContent('.status'), /Certified plan.*Cost.*kPa.*Clearance.*cm/s);
  assert.ok(!page.url().includes('token'), 'the token has left the address');
});

pageTest('the goal is dragged, a new plan follows, and undo takes the drag back', async (page) => {
  await select(page, 'Goal');
  const [x, y] = [await fieldValue(page, /^x/), await fieldValue(page, /^y/)];
  await page.evaluate(() => performance.clearMeasures());
  await drag(page, [x, y], [x - 0.03, y + 0.02]);
  assert.ok(Math.abs((await fieldValue(page, /^x/)) - (x - 0.03)) < 0.004);
  await page.waitForFunction(() => performance.getEntriesByType('measure').length > 0);
  await certified(page);
  await page.getByRole('button', { name: 'Undo' }).click();
  assert.equal(await fieldValue(page, /^x/), x);
  assert.equal(await fieldValue(page, /^y/), y);
  await page.getByRole('button', { name: 'Redo' }).click();
  assert.notEqual(await fieldValue(page, /^x/), x);
  await page.keyboard.press('Control+z');
  assert.equal(await fieldValue(page, /^x/), x);
});

pageTest('obstacles are added, moved, resized, turned and deleted', async (page) => {
  await certified(page);
  await page.getByLabel('Plan while dragging').uncheck();
  const count = () => page.locator('.things li').count();
  const before = await count();
  const savePlan = page.getByRole('button', { name: 'Save plan' });
  assert.ok(await savePlan.isEnabled());
  await page.getByRole('button', { name: 'Add a rectangle' }).click();
  assert.equal(await count(), before + 1);
  assert.ok(await savePlan.isDisabled(), 'the plan was of the scene without it');
  let at = [await fieldValue(page, /^x/), await fieldValue(page, /^y/)];
  await drag(page, at, [0.2, -0.3]);
  at = [await fieldValue(page, /^x/), await fieldValue(page, /^y/)];
  assert.ok(Math.hypot(at[0] - 0.2, at[1] + 0.3) < 0.005);
  await drag(page, [at[0] + 0.05, at[1] + 0.03], [at[0] + 0.08, at[1] + 0.05]);
  assert.ok(Math.abs((await fieldValue(page, /^Width/)) - 0.16) < 0.008);
  assert.ok(Math.abs((await fieldValue(page, /^Height/)) - 0.1) < 0.008);
  const turn = [at[0] + (await fieldValue(page, /^Width/)) / 2 + 0.05, at[1]];
  await drag(page, turn, [at[0], at[1] + 0.13]);
  assert.ok(Math.abs((await fieldValue(page, /^Angle/)) - Math.PI / 2) < 0.06);
  await page.keyboard.press('Delete');
  assert.equal(await count(), before);
  for (const kind of ['circle', 'polygon']) {
    await page.getByRole('button', { name: `Add a ${kind}` }).click();
  }
  assert.equal(await count(), before + 2);
  const labels = before - 1 + 2 + 3; // of obstacles, and of the selected one's corners
  await page.waitForFunction((count) => document.querySelectorAll('.grid-labels .thing').length === count, labels);
  await page.getByRole('button', { name: 'Add a corner' }).click();
  assert.equal(await page.locator('.field', { hasText: /^x \d/ }).count(), 4);
  await page.getByRole('button', { name: 'Remove corner 0' }).click();
  assert.equal(await page.locator('.field', { hasText: /^x \d/ }).count(), 3);
  await page.getByRole('button', { name: 'Delete', exact: true }).click();
  assert.equal(await count(), before + 1);
});

pageTest('where there is no plan, the reason stands there in words', async (page) => {
  await placeGoal(page, [3, 0]);
  await page.waitForSelector('.status.bad');
  assert.match(await page.textContent('.status'), /out of reach.*arm/is);
});

pageTest('what is saved is a file that limber verifies', async (page) => {
  await page.getByRole('button', { name: 'Add a circle' }).click();
  await certified(page);
  await page.getByRole('textbox', { name: 'Name to save as' }).fill('my own');
  await page.getByRole('button', { name: 'Save environment' }).click();
  await page.waitForFunction(() => document.getElementById('notice').textContent.startsWith('Saved'));
  assert.match(page.url(), /my\+own/, 'the address names the file');
  const environment = join(shared.studio.project, 'environments/my own.yaml');
  assert.match(readFileSync(environment, 'utf8'), /^schema: limber\/environment\/1\nname: "my own"/);
  await page.getByRole('textbox', { name: 'Name to save as' }).fill('my own');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.waitForFunction(() => !document.querySelector('.status em'));
  await page.getByRole('button', { name: 'Save plan' }).click();
  await page.waitForFunction(() => document.getElementById('notice').textContent.includes('plans/'));
  const plan = join(shared.studio.project, 'plans/my own.json');
  assert.ok(existsSync(plan));
  execFileSync(program, ['verify', '--model', network, '--environment', environment, '--plan', plan]);
  await page.getByRole('button', { name: 'Add a circle' }).click();
  await page.getByRole('textbox', { name: 'Name to save as' }).fill('other');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.waitForFunction(() => document.querySelector('.status.good') && !document.querySelector('.status em'));
  await page.getByRole('button', { name: 'Save plan' }).click();
  await page.getByText('Saved environments/other.yaml and plans/other.json').waitFor();
  await page.getByLabel('Saved plan').selectOption('plans/my own.json');
  await page.getByText('Opened plans/my own.json: its certificate was checked again, and holds').waitFor();
  assert.match(await page.textContent('.status.good'), /Certified plan/);
  assert.match(page.url(), /my\+own/, 'its environment is open');
  await page.getByRole('tab', { name: 'Play' }).click();
  await page.waitForSelector('.tracks li');
  const [others, its] = ['environments/other.yaml', 'plans/other.json'].map((name) => join(shared.studio.project, name));
  execFileSync(program, ['verify', '--model', network, '--environment', others, '--plan', its]);
});

pageTest('another model and environment are chosen, and tree and tube shown', async (page) => {
  await page.getByLabel('Model').selectOption('');
  await certified(page);
  await page.locator('.field', { hasText: /^Environment/ }).locator('select').selectOption('limber:05_between_pillars');
  await page.waitForURL(/05_between_pillars/);
  await certified(page);
  await page.waitForFunction(() => document.querySelector('.status.good.unsure'));
  assert.ok(await page.getByLabel('Tube: none in this plan').isDisabled(), 'the simple model has none');
  for (const name of ['Search tree', 'Reach']) await page.getByRole('checkbox', { name }).click();
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByRole('button', { name: 'Stop' }).click({ force: true }); // or it has just ended
  await page.waitForFunction(() =>
    [...document.querySelectorAll('button')].find((b) => b.textContent === 'Stop').disabled);
});

pageTest('an arm keeps the model that was chosen for it, and lists show files that come', async (page) => {
  const model = () => page.getByLabel('Model').inputValue();
  const arms = page.locator('.field', { hasText: /^Arm/ }).locator('select');
  const [mine, before] = [await arms.inputValue(), await model()];
  assert.notEqual(before, '');
  await arms.selectOption('limber:two_segment');
  await page.waitForURL(/two_segment/);
  assert.equal(await model(), '');
  await arms.selectOption(mine);
  await page.waitForURL((url) => !url.hash.includes('two_segment'));
  assert.equal(await model(), before);
  const folder = join(shared.studio.project, 'environments');
  mkdirSync(folder, { recursive: true });
  copyFileSync(join(root, 'environments/01_pillar.yaml'), join(folder, 'come.yaml'));
  await page.evaluate(() => dispatchEvent(new Event('focus')));
  await page.locator('option[value="environments/come.yaml"]').waitFor({ state: 'attached' });
});

pageTest('a link restores the scene, and undo still works', async (page) => {
  await page.getByLabel('Model').selectOption('');
  await page.getByRole('button', { name: 'Add a rectangle' }).click();
  await placeGoal(page, goal);
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page.getByText('Copied: a link that restores the scene').waitFor();
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), page.url());
  const { hash } = new URL(page.url());
  const token = new URL(shared.studio.address).searchParams.get('token');
  assert.ok(hash.includes('scene='));
  assert.ok(token && !decodeURIComponent(page.url()).includes(token), 'no token');
  const things = (of) => of.locator('.things li').allTextContents();
  const isRestored = async (there) => {
    assert.deepEqual(await things(there), await things(page));
    assert.equal(await there.getByLabel('Model').inputValue(), '');
    await select(there, 'Goal');
    assert.deepEqual([await fieldValue(there, /^x/), await fieldValue(there, /^y/)], goal);
  };
  const press = (there, name) => there.getByRole('button', { name }).click();

  const other = await openPage(shared.browser, shared.studio.address + hash); // as a colleague does
  await other.waitForSelector('.status.good, .status.bad');
  await isRestored(other);
  const undo = other.getByRole('button', { name: 'Undo' });
  assert.ok(await undo.isDisabled(), 'it begins with the link');
  await press(other, 'Add a circle');
  await press(other, 'Undo');
  await isRestored(other);
  await press(other, 'Redo');
  const edited = await things(other);
  await other.evaluate((link) => (location.hash = link), `${hash}&again`);
  await other.waitForFunction(
    (count) => document.querySelectorAll('.things li').length === count, edited.length - 1);
  await isRestored(other);
  await press(other, 'Undo');
  assert.deepEqual(await things(other), edited, 'undo takes the link back');
  await press(other, 'Redo');
  await isRestored(other);
  assert.deepEqual(other.faults, []);
  await other.context().close();

  const cut = await openPage(shared.browser, shared.studio.address + hash.slice(0, -9));
  await cut.getByText('The link’s scene can’t be read. Was the link cut off?').waitFor();
  await cut.waitForSelector('.status.good');
  assert.deepEqual(cut.faults, []);
  await cut.context().close();
});

pageTest('a plan is played by both models and the virtual arm', async (page) => {
  await page.getByRole('tab', { name: 'Play' }).click();
  await page.waitForSelector('.tracks');
  assert.equal(await page.locator('.tracks li').count(), 3);
  assert.match(await page.textContent('.tracks'), /Simple model.*Network.*Virtual arm.*(arrives|misses|strikes)/s);
  const slider = page.getByRole('slider', { name: 'Time in seconds' });
  await page.waitForFunction(() => Number(document.querySelector('.play input').value) > 0.2);
  await page.getByRole('button', { name: 'Pause' }).click();
  const there = await slider.inputValue();
  await page.waitForTimeout(200);
  assert.equal(await slider.inputValue(), there);
  await slider.focus();
  await page.keyboard.press('End');
  assert.match(await page.textContent('.plots'), /Pressure of segment 2.*set .*Network .*Virtual arm .*Tip from the virtual arm’s.*Clearance/s);
  const plot = await page.locator('.plots .u-over').first().boundingBox();
  const cursor = () => page.locator('.plots .u-cursor-x').first().boundingBox().then(({ x }) => x - plot.x);
  const end = await cursor();
  await page.mouse.click(plot.x + plot.width / 2, plot.y + plot.height / 2);
  await page.mouse.move(0, 0);
  assert.ok((await cursor()) < 0.7 * end, 'a click into a plot moves the slider');
  assert.ok(Number(await slider.inputValue()) > 0);
});

pageTest('an obstacle is dropped into the way; open loop the arm strikes it, closed loop it plans again', async (page) => {
  await page.getByRole('tab', { name: 'Play' }).click();
  await page.waitForSelector('.tracks');
  const outcome = () => page.locator('.tracks li', { hasText: 'Virtual arm' }).textContent();
  await page.getByLabel('Drop an obstacle').check();
  await page.waitForSelector('.tracks');
  const open = await outcome();
  await page.getByLabel('Closed loop').check();
  await page.waitForSelector('.tracks');
  assert.notEqual(await outcome(), open);
});

pageTest('the simple model’s plan is played although a closed loop was ticked for the network', async (page) => {
  await page.getByRole('tab', { name: 'Play' }).click();
  await page.getByLabel('Closed loop').check();
  await page.getByRole('tab', { name: 'Plan' }).click();
  await page.getByLabel('Model').selectOption('');
  await certified(page);
  await page.getByRole('tab', { name: 'Play' }).click();
  await page.waitForSelector('.tracks');
});

pageTest('driven there and back, the simple model returns and the virtual arm does not', async (page) => {
  await page.getByRole('tab', { name: 'Drive' }).click();
  const slider = page.getByRole('slider', { name: /Segment 0/ });
  await slider.focus();
  await page.keyboard.press('End');
  const away = (name) =>
    page.evaluate((key) => {
      const names = [...document.querySelectorAll('#readout dt')];
      const found = names.find((dt) => dt.textContent === key);
      return found ? parseFloat(found.nextElementSibling.textContent) : -1;
    }, name);
  for (const name of ['Simple model', 'Network', 'Virtual arm']) {
    while ((await away(name)) < 8) await page.waitForTimeout(50);
  }
  await page.getByRole('button', { name: 'All to zero' }).click();
  while ((await away('Simple model')) !== 0) await page.waitForTimeout(50);
  await page.waitForTimeout(2000);
  assert.ok((await away('Virtual arm')) > 0.05, 'friction holds it');
});

pageTest('everything goes by keyboard alone', async (page) => {
  await select(page, 'Goal');
  const x = await fieldValue(page, /^x/);
  await page.focus('#canvas');
  await page.keyboard.press('Shift+ArrowLeft');
  assert.ok(Math.abs((await fieldValue(page, /^x/)) - (x - 0.01)) < 1e-9);
  const label = () => page.locator('.grid-labels .x').first().evaluate((span) => span.style.left);
  const changesView = async (key) => {
    await page.focus('#canvas');
    const before = await label();
    await page.keyboard.press(key);
    while ((await label()) === before) await page.waitForTimeout(50);
  };
  await changesView('+');
  await page.keyboard.press('0');
  await page.keyboard.press('Escape');
  await changesView('ArrowRight');
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll('button, input, select')]
      .filter((e) => !(e.ariaLabel || e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.[0]?.textContent.trim()))
      .map((e) => e.outerHTML));
  assert.deepEqual(nameless, []);
  await page.focus('#mode-plan');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#mode-results[aria-selected=true]:focus');
  await changesView('ArrowLeft');
  await changesView('-');
  await page.getByRole('button', { name: 'Show everything' }).press('Enter');
});

pageTest('a finger drags, two fingers zoom', async (page) => {
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) =>
    client.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  await select(page, 'Goal');
  const at = [await fieldValue(page, /^x/), await fieldValue(page, /^y/)];
  await page.evaluate(() => document.getElementById('canvas').scrollIntoView());
  const from = await pixelsOf(page, at);
  await touch('touchStart', from);
  for (const back of [0.05, 0.1, 0.15]) { // browsers wait for some pixels before a finger moves
    await touch('touchMove', await pixelsOf(page, [at[0] - back, at[1]]));
  }
  await touch('touchEnd');
  assert.ok(Math.abs((await fieldValue(page, /^x/)) - (at[0] - 0.15)) < 0.01);
  const spread = async () => (await pixelsOf(page, [0.1, 0]))[0] - (await pixelsOf(page, [0, 0]))[0];
  const before = await spread();
  await touch('touchStart', [60, 300], [120, 300]);
  await touch('touchMove', [40, 300], [200, 300]);
  await touch('touchEnd');
  while ((await spread()) < 1.5 * before) await page.waitForTimeout(50);
}, { viewport: { width: 390, height: 844 }, hasTouch: true });

pageTest('a page that is closed leaves the others at work', async (page) => {
  const other = await openPage(shared.browser, shared.studio.address);
  await other.waitForSelector('.status.good');
  await other.context().close();
  await placeGoal(page, goal);
  await page.waitForSelector('.status.good, .status.bad');
});
