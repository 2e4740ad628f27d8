// The page of the embedded scene as people see it: light, dark, on a phone, and two files side by side. Writes the pictures
// into SHFORGE_OUT, to be looked at; prt/pictures/view.png is one of them. Tests what can be told without looking.
import assert from 'node:assert';
import fs from 'node:fs';
import path from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { message, prt, set, withPage, writeJson } from './browser.mjs';

const kOut = process.env.SHFORGE_OUT ?? 'out';
const kSky = { light: 'sky', sky: 12, elevation: 38, azimuth: -20, sun: 3, window: 'auto' };

before(() => {
  fs.mkdirSync(kOut, { recursive: true });
  prt('bake', 'demo', '-o', 'bounces.transfer', '--no-checkpoint', '--kind', 'interreflected');
  prt('bake', 'demo', '-o', 'direct.transfer', '--no-checkpoint', '--kind', 'shadowed');
  prt('view', 'bounces.transfer', 'direct.transfer', '--scene', 'demo', '-o', 'view.html');
});

// Nothing is wider than the page, no text is cut off at its side, and everything that is shown can be reached.
async function checkLayout(page, leastTarget) {
  assert.equal(await message(page), '');
  const flaws = await page.evaluate((least) => {
    const found = [];
    if (document.documentElement.scrollWidth > window.innerWidth) found.push('the page scrolls sideways');
    for (const control of document.querySelectorAll('#side select, #side input, #side button')) {
      const box = control.getBoundingClientRect();
      if (box.width === 0) continue;
      if (box.left < 0 || box.right > window.innerWidth) found.push(`${control.id} lies outside`);
      const row = control.closest('.row')?.getBoundingClientRect() ?? box;
      if (row.height < least) found.push(`${control.id} is ${row.height} high`);
      if (!control.labels?.length && !control.ariaLabel) found.push(`${control.id} has no label`);
    }
    return found;
  }, leastTarget);
  assert.deepEqual(flaws, []);
}

async function shown(name, state, options, leastTarget = 24, html = 'view.html') {
  await withPage(html, async (page) => {
    await set(page, state);
    await page.waitForFunction(() => /%/.test(document.getElementById('ringing').textContent));
    await checkLayout(page, leastTarget);
    await page.screenshot({ path: path.join(kOut, `${name}.png`) });
  }, options);
}

test('The page is laid out on a desk, in light and dark', async () => {
  const size = { width: 1000, height: 600 };
  await shown('view_light', { ...kSky, theme: 'light', vertex: 9000 }, size);
  await shown('view_dark', { ...kSky, theme: 'dark', compare: 'wipe' }, { ...size, colorScheme: 'dark' });
  await shown('view_difference', { ...kSky, compare: 'difference' }, size);
});

test('A stage and glossy surfaces are laid out, too', async () => {
  const scenes = fileURLToPath(new URL('../../prt/scenes/', import.meta.url));
  for (const part of ['floor', 'torus', 'arch', 'ball']) prt('bake', `${scenes}stage/${part}.json`, '-o', `${part}.transfer`, '--no-checkpoint', '--directions', 256);
  prt('view', `${scenes}stage/stage.json`, '--transfers', '.', '-o', 'stage.html');
  const size = { width: 1000, height: 600 };
  await shown('view_stage', { theme: 'light', vertex: 9000, time: 0.35 }, size, 24, 'stage.html');
  const dents = JSON.parse(fs.readFileSync(`${scenes}dents.json`, 'utf8'));
  for (const mesh of dents.meshes) Object.assign(mesh, { segments: 48, normal_map: `${scenes}dents.png` });
  writeJson('dents.json', { ...dents, ground: { ...dents.ground, size: 8, max_edge: 0.3 }, lights: [{ type: 'cie_overcast' }] });
  prt('bake', 'dents.json', '-o', 'dents.transfer', '--no-checkpoint', '--directions', 256);
  prt('view', 'dents.transfer', '--scene', 'dents.json', '-o', 'dents.html');
  await shown('view_dents', { ...kSky, theme: 'dark', distance: 13 }, size, 24, 'dents.html');
});

test('The page is laid out on a phone, with rows for fingers', async () => {
  await shown('view_phone', { ...kSky }, { width: 390, height: 780, deviceScaleFactor: 2, hasTouch: true, isMobile: true }, 40);
  await shown('view_phone_dark', { ...kSky }, { width: 320, height: 568, hasTouch: true, isMobile: true, colorScheme: 'dark' }, 40);
});
