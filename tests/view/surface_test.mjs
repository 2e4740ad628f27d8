// Surfaces whose receivers are texels, or that have textures: pictures beside `prt render`.
import assert from 'node:assert';
import fs from 'node:fs';
import { test } from 'node:test';
import { inFolder, prt, set, withPage, writeJson } from './browser.mjs';
import { canvasPicture, pictureOf, rootMeanSquare } from './pictures.mjs';

const kModel = '/usr/share/assimp/models/glTF2/BoxTextured-glTF/BoxTextured.gltf';
const kLimit = 0.016;  // seen: 0.0131, at the edges, and where a texture is finer than a pixel
const kWidth = 480, kHeight = 240;
const kSize = { width: kWidth + 312, height: kHeight };
const kSky = [{ type: 'cie_sky', sky: 12, sun: { elevation: 40, azimuth: -60 }, radiance: [0.5, 0.7, 1] }];
const kCamera = { position: [0.5, -5, 2.5], target: [0, 0, 0], field_of_view: 36 };

// A textured box over a floor of two triangles with an atlas, a ball with another one, and a shining plate without any.
function scene(name, { texels = 48, bake = {} } = {}) {
  return writeJson(name, {
    name: 'surfaces',
    meshes: [
      { file: kModel, emission: [0.1, 0.05, 0], max_edge: 0.2, transform: { rotate: { degrees: 30 }, translate: [0, 0, 0.1] } },
      { primitive: 'plane', albedo: [0.6, 0.5, 0.4], texels, transform: { scale: 4, translate: [0, 0, -0.5] } },
      { primitive: 'sphere', albedo: [0.3, 0.5, 0.7], texels: 24, transform: { scale: 0.8, translate: [1.3, -0.3, -0.05] } },
      { primitive: 'plane', emission: [0.4, 0.3, 0.1], max_edge: 0.3, transform: { scale: 0.6, translate: [-1.3, -0.3, -0.45] } },
    ],
    lights: kSky, camera: kCamera, bake: { degree: 3, directions: 256, ...bake },
  });
}

async function compare(name, limit = kLimit) {
  const shown = await withPage(`${name}.html`, async (page) => {
    await set(page, { exposure: 0.5 });
    return { picture: await canvasPicture(page), rendered: await pictureOf(page, inFolder(`${name}.png`)) };
  }, kSize);
  const difference = rootMeanSquare(shown.picture, shown.rendered);
  console.log(`  ${name}: rms ${difference.toFixed(4)}`);
  assert.ok(difference < limit, `${name}: rms ${difference}`);
  return shown.picture;
}

function baked(name, words, options) {
  scene(`${name}.json`, options);
  prt('bake', `${name}.json`, '-o', `${name}.transfer`, '--no-checkpoint', ...words);
  prt('render', `${name}.transfer`, '--scene', `${name}.json`, '-o', `${name}.png`, '--width', kWidth, '--height', kHeight, '--fixed-exposure', 0.5, '--background', 'grey', '--samples', 16);
  prt('view', `${name}.transfer`, '--scene', `${name}.json`, '-o', `${name}.html`);
}

test('Textures of glossy surfaces show as prt render shows them', async (context) => {
  if (!fs.existsSync(kModel)) return context.skip('no test models of assimp');
  for (const kind of ['glossy_unshadowed', 'glossy_shadowed', 'glossy_interreflected']) {
    writeJson(`${kind}.json`, {
      name: 'surfaces', lights: kSky, camera: kCamera, bake: { degree: 3, directions: 256 },
      meshes: [
        { file: kModel, max_edge: 0.2, transform: { rotate: { degrees: 30 }, translate: [0, 0, 0.1] } },
        { primitive: 'plane', albedo: [0.5, 0.4, 0.3], specular: [0.2, 0.2, 0.2], exponent: 20, max_edge: 0.2, transform: { scale: 4, translate: [0, 0, -0.5] } },
      ],
    });
    prt('bake', `${kind}.json`, '-o', `${kind}.transfer`, '--no-checkpoint', '--kind', kind);
    prt('render', `${kind}.transfer`, '--scene', `${kind}.json`, '-o', `${kind}.png`, '--width', kWidth, '--height', kHeight, '--fixed-exposure', 0.5, '--background', 'grey', '--samples', 16);
    prt('view', `${kind}.transfer`, '--scene', `${kind}.json`, '-o', `${kind}.html`);
    await compare(kind);
  }
});

// A shining floor of two triangles and a rough ball that may glow, each with an atlas; a metal ball without any casts shadows.
function glossyScene(name, texels, glows) {
  const emission = glows ? { emission: [0.2, 0.05, 0] } : {};
  return writeJson(name, {
    name: 'surfaces', lights: kSky, camera: kCamera, bake: { degree: 4, directions: 256 },
    meshes: [
      { primitive: 'plane', albedo: [0.4, 0.3, 0.2], specular: [0.3, 0.3, 0.3], exponent: 12, texels, transform: { scale: 4, translate: [0, 0, -0.5] } },
      { primitive: 'sphere', albedo: [0.3, 0.5, 0.7], ...emission, texels: Math.min(texels, 24), transform: { scale: 0.8, translate: [1.3, -0.3, -0.05] } },
      { primitive: 'sphere', segments: 24, albedo: [0.9, 0.7, 0.3], roughness: 0.5, metallic: 1, transform: { scale: 1.2, translate: [-0.6, 0.2, 0.15] } },
    ],
  });
}

test('Texels of glossy surfaces show as prt render shows them, for every glossy kind', async () => {
  const pictures = {};
  for (const [name, limit, texels, ...words] of [  // limits: a fourth above what is seen, at the edges
    ['gu', 0.0034, 32, '--kind', 'glossy_unshadowed'], ['gs', 0.0026, 48, '--kind', 'glossy_shadowed'], ['gs_coarse', 0.0035, 1, '--kind', 'glossy_shadowed'],
    ['gs_clustered', 0.0028, 48, '--kind', 'glossy_shadowed', '--compress', 8, 4], ['gi', 0.0017, 24, '--kind', 'glossy_interreflected'],
    ['gi_clustered', 0.0017, 40, '--kind', 'glossy_interreflected', '--compress', 8, 4]]) {
    glossyScene(`${name}.json`, texels, !name.startsWith('gi'));
    prt('bake', `${name}.json`, '-o', `${name}.transfer`, '--no-checkpoint', '--plan', 'none', ...words);
    prt('render', `${name}.transfer`, '--scene', `${name}.json`, '-o', `${name}.png`, '--width', kWidth, '--height', kHeight, '--fixed-exposure', 0.5, '--background', 'grey', '--samples', 16);
    prt('view', `${name}.transfer`, '--scene', `${name}.json`, '-o', `${name}.html`);
    pictures[name] = await compare(name, limit);
  }
  assert.ok(rootMeanSquare(pictures.gs, pictures.gs_coarse) > 0.02, 'the texels are seen');
});

test('Textures and texels show as prt render shows them, for every diffuse kind', async (context) => {
  if (!fs.existsSync(kModel)) return context.skip('no test models of assimp');
  for (const kind of ['unshadowed', 'shadowed', 'interreflected']) {
    baked(kind, ['--kind', kind], {});
    await compare(kind);
  }
  baked('clustered', ['--kind', 'interreflected', '--compress', 8, 4], { texels: 70 });  // receivers in a second row
  await compare('clustered');
  const fine = await compare('shadowed');
  baked('one', ['--kind', 'shadowed'], { texels: 1 });
  const coarse = await compare('one');
  assert.ok(rootMeanSquare(fine, coarse) > 2 * kLimit, 'the texels are seen');
});

test('An object of a stage keeps its texels and its texture where it moves', async (context) => {
  if (!fs.existsSync(kModel)) return context.skip('no test models of assimp');
  scene('staged.json');
  prt('bake', 'staged.json', '-o', 'staged.transfer', '--no-checkpoint', '--kind', 'shadowed');
  for (const lightAt of ['center', 'vertices']) {
    const name = `stage_${lightAt}`;
    writeJson(`${name}.json`, { objects: [{ transfer: 'staged.transfer', position: [0.1, 0, -0.1], rotate: { degrees: 20 }, light_at: lightAt }], lights: kSky, camera: kCamera });
    prt('render', `${name}.json`, '-o', `${name}.png`, '--width', kWidth, '--height', kHeight, '--fixed-exposure', 0.5, '--background', 'grey', '--samples', 16);
    prt('view', `${name}.json`, '-o', `${name}.html`);
    await compare(name);
  }
});
