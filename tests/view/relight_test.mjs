// Radiance of every vertex, read back from the GPU, beside `prt relight`: kinds, ways of storage, degrees, lights, windows.
import assert from 'node:assert';
import fs from 'node:fs';
import { test } from 'node:test';
import { inFolder, prt, radianceOf, radianceOfPly, relativeDifference, scene, set, withPage, writeJson } from './browser.mjs';

const kLimit = 2e-6;
const kLights = [
  { type: 'cie_sky', sky: 12, sun: { elevation: 35, azimuth: 40 }, radiance: [0.6, 0.8, 1.2] },
  { type: 'cap', direction: { elevation: 50, azimuth: -100 }, half_angle: 20, irradiance: [2, 1.5, 1] },
];

let largest = 0;

/** Bakes, relights with the tool, opens the page, compares. `expects` looks at the header of the file. */
async function compare(name, sceneOptions, words, expects = () => {}) {
  scene(`${name}.json`, sceneOptions);
  prt(words[0] === 'translucent' ? 'translucent' : 'bake', `${name}.json`, '-o', `${name}.transfer`, '--no-checkpoint',
    ...words.filter((word) => word !== 'translucent'));
  expects(JSON.parse(prt('info', `${name}.transfer`)));
  const light = writeJson(`${name}-light.json`, sceneOptions.lights ?? kLights);
  prt('relight', `${name}.transfer`, '--light', light, '-o', `${name}.ply`, '--eye', 3, -4, 3);
  prt('view', `${name}.transfer`, '--light', light, '-o', `${name}.html`);
  const difference = await withPage(`${name}.html`, async (page) => {
    await set(page, orbitFrom([3, -4, 3]));
    return relativeDifference(await radianceOf(page), radianceOfPly(`${name}.ply`));
  });
  largest = Math.max(largest, difference);
  console.log(`  ${name}: largest difference ${difference.toExponential(2)}`);
  assert.ok(difference <= kLimit, `${name}: ${difference} above ${kLimit}`);
}

/** The state of a camera there, that looks at the origin. */
export function orbitFrom([x, y, z]) {
  const distance = Math.hypot(x, y, z);
  return { target: [0, 0, 0], distance, yaw: (Math.atan2(y, x) * 180) / Math.PI, pitch: (Math.asin(z / distance) * 180) / Math.PI };
}

const element = (name) => (info) => assert.equal(info.storage?.element ?? 'single', name);
const kNoLoss = ['--plan', 'none'];

test('Diffuse kinds agree with prt relight at degrees 0, 4 and 10', async () => {
  for (const kind of ['unshadowed', 'shadowed', 'interreflected']) {
    for (const degree of [0, 4, 10]) await compare(`${kind}-${degree}`, { bake: { degree } }, ['--kind', kind, ...kNoLoss], element('single'));
  }
});

test('Rows in half precision and in 8 bits agree', async () => {
  for (const kind of ['shadowed', 'interreflected']) {
    await compare(`${kind}-half`, {}, ['--kind', kind, '--plan', 'lossy', '--error', 0.008, '--light-turns', 'any', '--without', 'bands,symmetry,directions,bounces'], element('half'));
    await compare(`${kind}-byte`, {}, ['--kind', kind, '--plan', 'lossy', '--error', 0.05, '--light-turns', 'any', '--without', 'bands,symmetry,directions,bounces'], element('byte'));
  }
});

test('Rows of which a file keeps some columns agree', async () => {
  const lights = [{ type: 'cie_overcast', radiance: [1, 0.9, 0.8] }];
  await compare('kept', { lights }, ['--kind', 'shadowed', '--plan', 'lossy', '--error', 0.01, '--without', 'bands,directions'],
    (info) => assert.ok(info.storage.kept.length > 0 && info.storage.kept.length < 25));
});

test('Rows of gray surfaces, of which one channel stands for three, agree', async () => {
  const mesh = { albedo: [0.5, 0.5, 0.5] };
  scene('gray.json', { mesh });
  const json = JSON.parse(fs.readFileSync(inFolder('gray.json'), 'utf8'));
  json.ground.albedo = [0.4, 0.4, 0.4];
  writeJson('gray.json', json);
  prt('bake', 'gray.json', '-o', 'gray.transfer', '--no-checkpoint', '--kind', 'interreflected');
  assert.equal(JSON.parse(prt('info', 'gray.transfer')).storage.one_channel, true);
  writeJson('gray-light.json', kLights);
  prt('relight', 'gray.transfer', '--light', 'gray-light.json', '-o', 'gray.ply');
  prt('view', 'gray.transfer', '--light', 'gray-light.json', '-o', 'gray.html');
  const difference = await withPage('gray.html', async (page) => relativeDifference(await radianceOf(page), radianceOfPly('gray.ply')));
  assert.ok(difference <= kLimit, `${difference}`);
});

test('Clustered rows agree', async () => {
  for (const kind of ['shadowed', 'interreflected']) {
    await compare(`${kind}-clusters`, {}, ['--kind', kind, '--compress', 8, 4], (info) => assert.ok(info.storage.clusters > 1));
  }
});

test('Emitted light is added', async () => {
  await compare('emitting', { mesh: { emission: [0.3, 0.2, 0.1] } }, ['--kind', 'interreflected', ...kNoLoss]);
});

test('Light through bodies agrees', async () => {
  const mesh = { albedo: [0.1, 0.1, 0.1], translucent: { transmission: [0.4, 0.6, 0.2], extinction: [1, 1, 2] } };
  await compare('translucent', { mesh }, ['translucent'], (info) => assert.equal(info.kind, 'DT'));
});

test('Meshes in a frame of their own agree', async () => {
  await compare('far', { mesh: { transform: { translate: [1000, 2000, 0] } } }, ['--kind', 'shadowed', ...kNoLoss]);
});

test('Glossy kinds agree at degrees 0, 2, 4 and 5', async () => {
  const mesh = { specular: [0.19, 0.15, 0.1], exponent: 12 };
  for (const kind of ['glossy_unshadowed', 'glossy_shadowed', 'glossy_interreflected']) {
    for (const degree of [0, 2, 4, 5]) await compare(`${kind}-${degree}`, { mesh, bake: { degree, directions: 128 } }, ['--kind', kind, ...kNoLoss]);
  }
});

test('Glossy transfer agrees over BRDFs, in clusters, and where files keep fewer bands or bits', async () => {
  const rough = { roughness: 0.5, metallic: 0.3 };
  const bake = { degree: 3, directions: 128 };
  await compare('rough', { mesh: rough, bake }, ['--kind', 'glossy_shadowed', ...kNoLoss]);
  await compare('rough-unshadowed', { mesh: rough, bake }, ['--kind', 'glossy_unshadowed', ...kNoLoss]);
  await compare('glossy-clusters', { mesh: { specular: [0.19, 0.15, 0.1], exponent: 12 }, bake }, ['--kind', 'glossy_interreflected', '--compress', 8, 4]);
  await compare('glossy-bands', { mesh: rough, bake: { ...bake, keep: { visibility: 4, result: 2, light: 1 } } }, ['--kind', 'glossy_interreflected']);
  await compare('glossy-byte', { mesh: rough, bake }, ['--kind', 'glossy_shadowed', '--plan', 'lossy', '--error', 0.2, '--without', 'bands,visibility,directions'], element('byte'));
});

test('Files of version 1 agree with the radiance that older builds gave', async () => {
  for (const name of ['shadowed', 'kept_half', 'byte_emitted_mirror']) {
    fs.copyFileSync(new URL(`../data/transfer_v1/${name}.transfer`, import.meta.url), inFolder(`${name}.transfer`));
    prt('relight', `${name}.transfer`, '-o', `${name}.ply`);
    prt('view', `${name}.transfer`, '-o', `${name}.html`);
    const difference = await withPage(`${name}.html`, async (page) => relativeDifference(await radianceOf(page), radianceOfPly(`${name}.ply`)));
    assert.ok(difference <= kLimit, `${name}: ${difference}`);
  }
});

/** One page for the lights: set the state, compare with lights of the tool. */
async function withLights(use) {
  scene('lights.json');
  prt('bake', 'lights.json', '-o', 'lights.transfer', '--no-checkpoint', ...kNoLoss);
  prt('view', 'lights.transfer', '-o', 'lights.html');
  await withPage('lights.html', async (page) => {
    await use(async (name, state, lights, ...words) => {
      await set(page, state);
      prt('relight', 'lights.transfer', '--light', writeJson('one.json', lights), '-o', 'one.ply', ...words);
      const difference = relativeDifference(await radianceOf(page), radianceOfPly('one.ply'));
      console.log(`  ${name}: largest difference ${difference.toExponential(2)}`);
      assert.ok(difference <= kLimit, `${name}: ${difference}`);
    }, page);
  });
}

test('Skies, suns and discs of the page are those of scenes', async () => {
  await withLights(async (agrees) => {
    for (const [sky, elevation, azimuth] of [[1, 0, 0], [7, 20, 170], [12, 35, 40], [15, 90, -90]]) {
      const sun = { elevation, azimuth };
      await agrees(`sky ${sky}`, { light: 'sky', sky, elevation, azimuth, sun: 2 },
        [{ type: 'cie_sky', sky, sun }, { type: 'cap', direction: sun, half_angle: 0.2666, irradiance: [2, 2, 2] }]);
    }
    await agrees('overcast', { light: 'sky', sky: 16 }, [{ type: 'cie_overcast' }]);
    for (const halfAngle of [0.25, 10, 90]) {
      await agrees(`disc of ${halfAngle} degrees`, { light: 'cap', elevation: 30, azimuth: -50, halfAngle, irradiance: 3 },
        [{ type: 'cap', direction: { elevation: 30, azimuth: -50 }, half_angle: halfAngle, irradiance: [3, 3, 3] }]);
    }
  });
});

test('Windows and lower degrees of the page are those of prt', async () => {
  await withLights(async (agrees) => {
    const disc = { light: 'cap', elevation: 60, azimuth: 20, halfAngle: 5, irradiance: 2 };
    const lights = [{ type: 'cap', direction: { elevation: 60, azimuth: 20 }, half_angle: 5, irradiance: [2, 2, 2] }];
    const odds = 0.2 / 0.8;
    for (const [window, number] of [['hann', 5], ['lanczos', 5], ['laplacian', odds ** 4], ['gaussian', 1 / odds], ['fejer', 0.2]]) {
      await agrees(window, { ...disc, window, strength: 0.2 }, lights, '--window', `${window === 'lanczos' ? 'sinc' : window}:${number}`);
    }
    await agrees('auto', { ...disc, window: 'auto' }, lights, '--window', 'auto');
    await agrees('degree 2', { ...disc, window: 'none', degree: 2 }, lights, '--degree', 2);
  });
});
