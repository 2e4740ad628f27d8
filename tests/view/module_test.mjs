// The module that `prt view` writes for other pages: in three.js, and by its own class.
import assert from 'node:assert';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { before, test } from 'node:test';
import { inFolder, prt, radianceOfPly, relativeDifference, scene, withServedPage, writeJson } from './browser.mjs';
import { decoded, pictureOf, rootMeanSquare } from './pictures.mjs';

const kLight = [{ type: 'cie_sky', sky: 12, sun: { elevation: 40, azimuth: -60 }, radiance: [0.5, 0.7, 1] }];
const kCamera = { position: [4, -4, 3], target: [0.2, 0, 0.3], field_of_view: 40 };
const kExample = new URL('../../prt/view/example/', import.meta.url);
const kThree = path.dirname(createRequire(import.meta.url).resolve('three'));
const kSize = { width: 480, height: 320 };

before(() => {
  writeJson('sky.json', kLight);
  fs.writeFileSync(inFolder('light.json'), prt('project', 'sky.json', '--degree', 4));
});

function bake(kind, mesh, ...words) {
  scene('demo.json', { mesh: { max_edge: 0.25, ...mesh }, lights: kLight, camera: kCamera, bake: { directions: 256 } });
  prt('bake', 'demo.json', '-o', 'demo.transfer', '--kind', kind, '--no-checkpoint', ...words);
  prt('view', 'demo.transfer', '-o', 'relight.js');
}

const kFiles = {
  'three.html': new URL('three.html', kExample), 'three_material.js': new URL('three_material.js', kExample),
  'three.module.js': path.join(kThree, 'three.module.js'), 'three.core.js': path.join(kThree, 'three.core.js'),
};

test('The example in three.js shows what prt render shows', async () => {
  for (const [kind, mesh, words] of [['shadowed', {}, []], ['interreflected', {}, ['--plan', 'lossy', '--error', 0.02, '--without', 'bands,symmetry,directions']],
                                     ['glossy_shadowed', { specular: [0.19, 0.19, 0.19], exponent: 12 }, []]]) {
    bake(kind, mesh, ...words);
    prt('render', 'demo.transfer', '--scene', 'demo.json', '-o', 'three.png', '--width', kSize.width, '--height', kSize.height, '--fixed-exposure', 1, '--tone', 'linear', '--background', 'grey');
    await withServedPage('three.html', kFiles, async (page) => {
      const difference = rootMeanSquare(await decoded(page, await page.screenshot()), await pictureOf(page, inFolder('three.png')));
      console.log(`  three.js, ${kind}: rms ${difference.toFixed(4)}`);
      assert.ok(difference < 0.03, `${kind}: rms ${difference}`);
    }, kSize);
  }
});

test('Relighter gives the radiance of prt relight, and refuses what is no file of its kind', async () => {
  for (const [kind, words] of [['interreflected', ['--plan', 'none']], ['shadowed', ['--compress', 8, 4]]]) {
    bake(kind, {}, ...words);
    prt('relight', 'demo.transfer', '--scene', 'demo.json', '-o', 'demo.ply');
    fs.writeFileSync(inFolder('own.html'), `<!doctype html><link rel="icon" href="data:,"><script type="module">
      import { FileError, load, Relighter, runtime, turned } from './relight.js';
      const bytes = new Uint8Array(await (await fetch('demo.transfer')).arrayBuffer());
      const { degree, coefficients } = await (await fetch('light.json')).json();
      const light = { degree, values: Float64Array.from(coefficients.flat()) };
      const baked = load(bytes, runtime);
      const relighter = new Relighter(document.createElement('canvas').getContext('webgl2'), baked);
      relighter.relight(turned(baked.kernels, light, [1, 0, 0, 0, 1, 0, 0, 0, 1]));
      globalThis.radiance = [...relighter.read()];
      relighter.dispose();
      bytes[100] ^= 1;
      try { load(bytes, runtime); } catch (error) { globalThis.refusal = error instanceof FileError ? error.message : 'another error'; }
      document.documentElement.dataset.ready = 'true';</script>`);
    await withServedPage('own.html', {}, async (page) => {
      assert.ok(relativeDifference(Float32Array.from(await page.evaluate(() => radiance)), radianceOfPly('demo.ply')) < 2e-6);
      assert.equal(await page.evaluate(() => refusal), 'damaged transfer file: the checksum of its section table differs');
    }, kSize);
  }
});

test('The types of the module fit a strict use, and name what the module has', async () => {
  const folder = inFolder('types');
  fs.mkdirSync(folder);
  fs.copyFileSync(new URL('../../prt/view/relight.d.ts', import.meta.url), path.join(folder, 'relight.d.ts'));
  fs.copyFileSync(new URL('use_of_module.ts', import.meta.url), path.join(folder, 'use.ts'));
  const compiler = createRequire(import.meta.url).resolve('typescript/bin/tsc');
  const run = spawnSync(process.execPath, [compiler, '--strict', '--noEmit', '--noUncheckedIndexedAccess', '--target', 'es2022', '--module', 'es2022',
    '--lib', 'es2022,dom', '--moduleResolution', 'bundler', path.join(folder, 'use.ts')], { encoding: 'utf8' });
  assert.equal(run.stdout + run.stderr, '');
  assert.equal(run.status, 0);
  // What the types name as values, the module exports; and its class has those members.
  bake('shadowed', {});
  const types = fs.readFileSync(path.join(folder, 'relight.d.ts'), 'utf8');
  const names = [...types.matchAll(/^export (?:class|const|function) (\w+)/gm)].map(([, name]) => name);
  fs.copyFileSync(inFolder('relight.js'), path.join(folder, 'relight.mjs'));
  const module = await import(pathToFileURL(path.join(folder, 'relight.mjs')).href);
  for (const name of names) assert.ok(name in module, `${name} is exported`);
  const [, members] = /export class Relighter \{([^]*?)\n\}/.exec(types);
  for (const [, name] of members.matchAll(/^ {2}(\w+)\(/gm)) assert.ok(name === 'constructor' || name in module.Relighter.prototype, name);
  const baked = module.load(new Uint8Array(fs.readFileSync(inFolder('demo.transfer'))), module.runtime);
  for (const [type, value] of [['Baked', baked], ['Transfer', baked.transfer], ['Shape', baked.transfer.shape], ['Runtime', module.runtime], ['Attribute', baked.attributes[0]], ['NumberTexture', baked.textures[0]]]) {
    const [, body] = new RegExp(`export interface ${type} \\{([^]*?)\\n\\}`).exec(types);
    for (const [, name] of body.matchAll(/^ {2}(\w+):/gm)) assert.ok(name in value, `${type}.${name}`);
  }
});
