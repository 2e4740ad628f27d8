// Media: their points beside the numbers of the file, their pictures beside `prt render`, and files that do not fit.
import assert from 'node:assert';
import fs from 'node:fs';
import { test } from 'node:test';
import { inFolder, message, pageWith, prt, radianceOf, refusal, relativeDifference, scene, set, withPage, writeJson } from './browser.mjs';
import { canvasPicture, pictureOf, rootMeanSquare } from './pictures.mjs';

const kLimit = 0.004;  // seen: 0.0018
const kWidth = 480, kHeight = 240;
const kSize = { width: kWidth + 312, height: kHeight };
const kLights = [{ type: 'cie_clear', sun: { elevation: 35, azimuth: 200 }, radiance: [0.5, 0.72, 1] },
                 { type: 'cap', direction: { elevation: 35, azimuth: 200 }, half_angle: 15, irradiance: [5, 4.4, 3.6] }];

function cloud(name, { density = {}, medium = {}, bake = {}, camera = { position: [1, -5.2, -1.9], target: [0, 0, 0], field_of_view: 32 } } = {}) {
  return writeJson(`${name}.json`, {
    name, lights: kLights, camera,
    medium: { density: { made: 'cloud', counts: [16, 14, 10], seed: 4, ...density }, box: [[-1.6, -1.45, -0.95], [1.6, 1.45, 0.95]], extinction: 16, albedo: [0.98, 0.9, 0.8], ...medium },
    bake: { degree: 4, directions: 24, tolerance: 0.01, ...bake },
  });
}

function baked(name, options) {
  cloud(name, options);
  prt('bake', `${name}.json`, '-o', `${name}.transfer`);
  prt('view', `${name}.transfer`, '--scene', `${name}.json`, '-o', `${name}.html`);
}

const render = (name, out, ...words) => prt('render', `${name}.transfer`, '--scene', `${name}.json`, '-o', out, '--width', kWidth, '--height', kHeight, '--samples', 4, ...words);

// What the points of a file of single precision send: their numbers times the light of the page.
async function sentByNumbers(page) {
  return new Float32Array(await page.evaluate(() => {
    const { transfer } = viewer.first;
    const light = viewer.lighting.of(viewer.state);
    const n = (transfer.shape.degree + 1) ** 2;
    return Array.from({ length: 3 * transfer.vertices }, (_, i) => (
      transfer.sections.transfer.subarray(i * n, (i + 1) * n).reduce((sum, value, k) => sum + value * light.values[(i % 3) * n + k], 0)));
  }));
}

test('Points send what their numbers give, at every degree of the light', async () => {
  baked('cloud', {});
  await withPage('cloud.html', async (page) => {
    for (const degree of [4, 2, 0]) {
      await set(page, { degree });
      const difference = relativeDifference(await radianceOf(page), await sentByNumbers(page));
      assert.ok(difference < 2e-6, `degree ${degree}: ${difference}`);
    }
  }, kSize);
});

test('Pictures are those of prt render: a cloud, smoke, a cell of few voxels, from inside, and a light that turned', async () => {
  const inside = { position: [0.2, 0.1, 0], target: [1, 0.5, 0.3], field_of_view: 60 };
  const cases = [['cloud', {}], ['smoke', { density: { made: 'smoke', counts: [8, 8, 24] } }], ['few', { density: { made: 'uniform', counts: [1, 1, 2] }, medium: { extinction: 0.5 } }],
                 ['forward', { medium: { phase: { henyey_greenstein: 0.7 } }, bake: { degree: 3 } }], ['backward', { density: { counts: [6, 5, 4] }, medium: { phase: { henyey_greenstein: -0.5 } }, bake: { degree: 1 } }],
                 ['black', { medium: { albedo: [0, 0, 0] } }], ['inside', { camera: inside, medium: { extinction: 2 } }]];
  for (const [name, options] of cases) {
    baked(name, options);
    await withPage(`${name}.html`, async (page) => {
      for (const tone of name === 'cloud' ? ['neutral', 'reinhard', 'linear'] : ['neutral']) {
        render(name, 'picture.png', '--fixed-exposure', 0.3, '--tone', tone, '--background', 'grey');
        await set(page, { exposure: 0.3, stops: 0, tone });
        const difference = rootMeanSquare(await canvasPicture(page), await pictureOf(page, inFolder('picture.png')));
        console.log(`  ${name}, ${tone}: rms ${difference.toFixed(4)}`);
        assert.ok(difference < kLimit, `${name}, ${tone}: rms ${difference}`);
      }
    }, kSize);
  }
  await withPage('cloud.html', async (page) => {
    await set(page, { exposure: 0.3, tone: 'neutral' });
    const before = await canvasPicture(page);
    await set(page, { turn: [Math.SQRT1_2, 0, 0, Math.SQRT1_2] });
    assert.ok(rootMeanSquare(before, await canvasPicture(page)) > 3 * kLimit, 'a turned light is seen');
    await set(page, { turn: [1, 0, 0, 0], background: 'light' });
    assert.ok(rootMeanSquare(before, await canvasPicture(page)) > 3 * kLimit, 'the light behind is seen');
  }, kSize);
});

test('The measured exposure is that of prt render', async () => {
  render('cloud', 'auto.png', '--background', 'grey');
  await withPage('cloud.html', async (page) => {
    const difference = rootMeanSquare(await canvasPicture(page), await pictureOf(page, inFolder('auto.png')));
    assert.ok(difference < 2 * kLimit, `rms ${difference}`);
  }, kSize);
});

test('Half precision and a mesh beside it are shown, and no vertex is chosen', async () => {
  scene('mesh.json');
  prt('bake', 'mesh.json', '-o', 'mesh.transfer', '--no-checkpoint');
  prt('view', 'cloud.transfer', 'mesh.transfer', '--scene', 'cloud.json', '-o', 'both.html');
  await withPage('both.html', async (page) => {
    await page.mouse.click(kWidth / 2, kHeight / 2);
    assert.equal(await page.evaluate(() => viewer.state.vertex), -1);
    for (const compare of ['wipe', 'difference', 'none']) await set(page, { compare, b: 1 });
    assert.equal(await message(page), '');
    assert.match(await page.textContent('#facts'), /^DV, degree 4, single · 16 x 14 x 10 voxels/);
  }, kSize);
});

test('What does not fit is refused in one line, and a changed byte with the words of prt', async () => {
  assert.match(refusal('view', 'cloud.transfer', '-o', 'cloud.js'), /expected one of/);
  const bytes = fs.readFileSync(inFolder('cloud.transfer'));
  const table = (k) => Number(bytes.readBigUInt64LE(48 + 40 * k + 24));
  const changes = [48 + 40 * bytes.readUInt32LE(12) + 5, ...Array.from({ length: bytes.readUInt32LE(12) }, (_, k) => table(k) + 6)];
  for (const at of changes) {
    const damaged = Buffer.from(bytes.map((byte, i) => (i === at ? byte ^ 4 : byte)));
    fs.writeFileSync(inFolder('bad.transfer'), damaged);
    pageWith('cloud.html', 'damaged.html', damaged);
    const words = refusal('info', 'bad.transfer', '--check').replace('bad.transfer', 'cloud.transfer');
    await withPage('damaged.html', async (page) => assert.equal(await message(page), words), kSize);
  }
});
