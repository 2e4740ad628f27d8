// Glossy surfaces pixel by pixel, with normal maps, lobes and BRDFs: pictures beside `prt render`.
import assert from 'node:assert';
import fs from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { inFolder, prt, set, withPage, writeJson } from './browser.mjs';
import { canvasPicture, pictureOf, rootMeanSquare } from './pictures.mjs';

const kDents = fileURLToPath(new URL('../../prt/scenes/dents.png', import.meta.url));
const kLimit = 0.014;  // seen: 0.0105, at the edges
const kWidth = 480, kHeight = 240;
const kSize = { width: kWidth + 312, height: kHeight };

// Two squares side by side that face -y; the right one shows the picture mirrored.
const kSheet = `v -1 0 0\nv 0 0 0\nv 1 0 0\nv -1 0 1\nv 0 0 1\nv 1 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1
f 1/1 2/2 5/4 4/3\nf 2/2 3/1 6/3 5/4\n`;

// A clay ball, a ring of rough metal and a ball with a lobe, all with dents; a smooth box with a lobe. Or other meshes.
function dentedScene(name, { mapped = kDents, bake = {}, meshes } = {}) {
  const map = mapped ? { normal_map: mapped } : {};
  return writeJson(name, {
    name: 'dented',
    meshes: meshes ?? [
      { primitive: 'sphere', segments: 32, albedo: [0.7, 0.5, 0.4], ...map, transform: { translate: [-1.2, 0, 0] } },
      { primitive: 'torus', segments: 32, albedo: [0.9, 0.7, 0.3], roughness: 0.5, metallic: 1, ...map, transform: { rotate: { axis: [1, 0, 0], degrees: 60 } } },
      { primitive: 'box', albedo: [0.1, 0.1, 0.3], specular: [0.5, 0.5, 0.5], exponent: 20, max_edge: 0.3, transform: { translate: [1.2, 0, 0], rotate: { degrees: 30 } } },
      { primitive: 'sphere', segments: 32, albedo: [0.2, 0.2, 0.2], specular: [0.4, 0.4, 0.4], exponent: 10, ...map, transform: { scale: 0.6, translate: [0, -1.2, 0.2] } },
    ],
    lights: [{ type: 'cie_sky', sky: 12, sun: { elevation: 40, azimuth: -60 }, radiance: [0.5, 0.7, 1] }, { type: 'cap', direction: { elevation: 40, azimuth: -60 }, half_angle: 15, irradiance: [3, 3, 3] }],
    camera: { position: [0.5, -5, 1.5], target: [0, 0, 0], field_of_view: 36 },
    bake: { degree: 4, directions: 128, ...bake },
  });
}

async function compare(name, file, words, { options } = {}) {
  dentedScene(file, options);
  prt('bake', file, '-o', `${name}.transfer`, '--no-checkpoint', ...words);
  prt('render', `${name}.transfer`, '--scene', file, '-o', `${name}.png`, '--width', kWidth, '--height', kHeight, '--fixed-exposure', 0.5, '--background', 'grey', '--samples', 4);
  prt('view', `${name}.transfer`, '--scene', file, '-o', `${name}.html`);
  return withPage(`${name}.html`, async (page) => {
    await set(page, { exposure: 0.5 });
    const shown = await canvasPicture(page);
    const difference = rootMeanSquare(shown, await pictureOf(page, inFolder(`${name}.png`)));
    console.log(`  ${name}: rms ${difference.toFixed(4)}`);
    assert.ok(difference < kLimit, `${name}: rms ${difference}`);
    return shown;
  }, kSize);
}

test('Normal maps, lobes and BRDFs are those of prt render, at every pixel', async () => {
  const plain = ['--plan', 'none'];
  fs.writeFileSync(inFolder('sheet.obj'), kSheet);
  const shadowed = await compare('dented', 'dented.json', ['--kind', 'glossy_shadowed', ...plain], {});
  await compare('unshadowed', 'dented.json', ['--kind', 'glossy_unshadowed', ...plain], { options: { bake: { degree: 7 } } });
  await compare('bounced', 'dented.json', ['--kind', 'glossy_interreflected', '--compress', 8, 4], { options: { bake: { degree: 2 } } });
  const sheet = { file: 'sheet.obj', albedo: [0.4, 0.5, 0.4], specular: [0.3, 0.3, 0.3], exponent: 8, emission: [0.2, 0.1, 0], normal_map: kDents, max_edge: 0.5, transform: { scale: 1.8, translate: [0, 0, -0.9] } };
  await compare('mirrored', 'mirrored.json', ['--kind', 'glossy_shadowed', ...plain], { options: { meshes: [sheet], bake: { degree: 2 } } });
  dentedScene('smooth.json', { mapped: null });
  prt('bake', 'smooth.json', '-o', 'smooth.transfer', '--no-checkpoint', '--kind', 'glossy_shadowed', ...plain);
  prt('render', 'smooth.transfer', '--scene', 'smooth.json', '-o', 'smooth.png', '--width', kWidth, '--height', kHeight, '--fixed-exposure', 0.5, '--background', 'grey');
  await withPage('dented.html', async (page) => assert.ok(rootMeanSquare(shadowed, await pictureOf(page, inFolder('smooth.png'))) > 2 * kLimit, 'the maps are seen'));
});
