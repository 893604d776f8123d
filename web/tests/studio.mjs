// The real program and Debian's Chromium, for tests, screenshots and measurements.

import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

export const root = fileURLToPath(new URL('../..', import.meta.url));
export const program = process.env.LIMBER_PROGRAM ?? join(root, 'build/release/bin/limber');
export const network = join(root, 'tests/data/closed_loop/ten_hours.safetensors');

export const kPatience_ms = 120000; // on a busy machine; no test asks how long anything takes

/** `limber studio` on a free port, its project a new empty folder. */
export async function startStudio(...flags) {
  const project = mkdtempSync(join(tmpdir(), 'limber_studio_page_'));
  const server = spawn(program, ['studio', '--port', '0', '--json', '--project', project, ...flags]);
  server.stderr.pipe(process.stderr);
  const address = await new Promise((resolve, reject) => {
    let text = '';
    server.stdout.on('data', (piece) => {
      text += piece;
      if (text.includes('}')) resolve(JSON.parse(text).address);
    });
    server.on('exit', (code) => reject(new Error(`limber studio ended with ${code}`)));
  });
  const stop = () =>
    new Promise((resolve) => {
      server.removeAllListeners('exit');
      server.on('exit', (code) => {
        rmSync(project, { recursive: true, force: true });
        resolve(code);
      });
      server.kill('SIGINT');
    });
  return { address, project, stop, pid: server.pid };
}

export const startBrowser = () =>
  chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });

/**
 * With LIMBER_PAGE=dist, that folder's page instead of the one in the program: a change of the page
 * is tried before the program is built with it. The rules that come with the program's page hold.
 */
async function usePage(context, address) {
  const folder = process.env.LIMBER_PAGE;
  if (!folder) return address;
  const { origin, hash } = new URL(address);
  await context.request.get(address); // the token becomes a cookie
  await context.route((url) => /^\/($|assets\/|animation\.html)/.test(url.pathname), async (route) => {
    const name = new URL(route.request().url()).pathname.replace(/\/$/, '/index.html');
    await route.fulfill({ response: await route.fetch(), body: readFileSync(join(folder, name)) });
  });
  return `${origin}/${hash}`;
}

/** A page with its stage's scale, read off the grid's labels as people do. */
export async function openPage(browser, address, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(kPatience_ms);
  page.faults = [];
  page.on('pageerror', (error) => page.faults.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') page.faults.push(message.text());
  });
  await page.goto(await usePage(context, address));
  await page.waitForSelector('.grid-labels .x');
  return page;
}

/** Pixels of a point in metres. */
export async function pixelsOf(page, [x_m, y_m]) {
  const scale = await page.evaluate(() => {
    const axis = (name, side) =>
      [...document.querySelectorAll(`.grid-labels .${name}`)].map((label) => [
        parseFloat(label.textContent),
        parseFloat(label.style[side]),
      ]);
    const box = document.getElementById('canvas').getBoundingClientRect();
    return { x: axis('x', 'left'), y: axis('y', 'top'), left: box.left, top: box.top };
  });
  const along = (ticks, value) => {
    const [[a, at], [b, bt]] = [ticks[0], ticks[ticks.length - 1]];
    return at + ((value - a) / (b - a)) * (bt - at);
  };
  return [scale.left + along(scale.x, x_m), scale.top + along(scale.y, y_m)];
}

export async function drag(page, from_m, to_m, steps = 6) {
  await page.mouse.move(...(await pixelsOf(page, from_m)));
  await page.mouse.down();
  await page.mouse.move(...(await pixelsOf(page, to_m)), { steps });
  await page.mouse.up();
}

/** The number in a field of the panel. */
export const fieldValue = (page, label) =>
  page.locator('.field', { hasText: label }).locator('input').first().inputValue().then(Number);
