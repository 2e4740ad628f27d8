// Stages: several objects that turn and move, each under its own light and the shadows of the others, beside prt.
import assert from 'node:assert';
import fs from 'node:fs';
import { before, test } from 'node:test';
import { clicksAtCorners, inFolder, message, prt, radianceOf, radianceOfPly, refusal, relativeDifference, set, withPage, writeJson } from './browser.mjs';
import { canvasPicture, pictureOf, rootMeanSquare } from './pictures.mjs';

const kLights = [{ type: 'cie_clear', sun: { elevation: 35, azimuth: 150 }, radiance: [0.4, 0.5, 0.7] },
                 { type: 'cap', direction: { elevation: 35, azimuth: 150 }, half_angle: 12, irradiance: [3, 2.7, 2.2] }];
const kCamera = { position: [2.2, -6.2, 3.4], target: [0, -0.2, 0.7], field_of_view: 34 };
const kWidth = 480, kHeight = 320;
const kSize = { width: kWidth + 312, height: kHeight };

function bake(name, mesh, degree, kind, ...words) {
  writeJson(`${name}.json`, { name, meshes: [mesh], bake: { degree, directions: 128 } });
  prt('bake', `${name}.json`, '-o', `${name}.transfer`, '--kind', kind, '--no-checkpoint', ...words);
}

const kObjects = [
  { transfer: 'torus.transfer', rotate: { axis: [1, 1, 0], degrees: 25 }, proxy: { radius: 0.6 },
    move: [{ time: 0.1, position: [-1.1, 0, 1.1] }, { time: 0.6, position: [-1.1, 0.4, 1.1], degrees: 200 }, { time: 1, degrees: 360, position: [-1.1, 0, 1.1] }] },
  { transfer: 'arch.transfer', position: [1.1, 0.3, 0.75], rotate: { axis: [0, 0, 1], degrees: -70 } },
  { transfer: 'ball.transfer', light_at: 'vertices', move: [{ time: 0, position: [0, -1.3, 0.6] }, { time: 0.5, position: [0, -1.3, 1.2] }] },
  { transfer: 'ball.transfer', position: [0.4, 1.4, 0.7], rotate: { axis: [1, 0, 0], degrees: 180 } },
  { transfer: 'floor.transfer', proxy: { radius: 0 }, light_at: 'vertices' },
];

before(() => {
  bake('floor', { primitive: 'plane', albedo: [0.6, 0.6, 0.62], transform: { scale: 7 }, max_edge: 0.5 }, 6, 'unshadowed', '--plan', 'none');
  bake('torus', { primitive: 'torus', segments: 24, albedo: [0.75, 0.3, 0.1], transform: { scale: 1.4 }, max_edge: 0.3 }, 4, 'interreflected', '--plan', 'none');
  bake('arch', { primitive: 'arch', albedo: [0.25, 0.45, 0.65], max_edge: 0.2, transform: { translate: [1000, 0, 0] } }, 6, 'shadowed', '--plan', 'none');
  bake('ball', { primitive: 'sphere', albedo: [0.7, 0.7, 0.7], max_edge: 0.3 }, 5, 'shadowed', '--compress', 4, 3);
  const objects = kObjects.map((object) => (object.transfer === 'arch.transfer' ? { ...object, position: [1.1 - 1000 * Math.cos((70 * Math.PI) / 180), 0.3 + 1000 * Math.sin((70 * Math.PI) / 180), 0.75] } : object));
  writeJson('stage.json', { name: 'turning', objects, lights: kLights, camera: kCamera });
  prt('view', 'stage.json', '-o', 'stage.html');
});

test('Radiance is that of prt relight, at several times and degrees, under a turned light', async () => {
  prt('relight', 'stage.json', '-o', 'frames.ply', '--frames', 5);
  prt('relight', 'stage.json', '-o', 'low.ply', '--degree', 3);
  prt('relight', 'stage.json', '-o', 'turned.ply', '--turn', 40);
  await withPage('stage.html', async (page) => {
    const agrees = async (name, state) => {
      await set(page, state);
      const difference = relativeDifference(await radianceOf(page), radianceOfPly(name));
      console.log(`  ${name}: largest difference ${difference.toExponential(2)}`);
      assert.ok(difference <= 2e-6, `${name}: ${difference}`);
      return radianceOf(page);
    };
    const all = [];
    for (const [frame, name] of ['frames_000', 'frames_001', 'frames_002', 'frames_003', 'frames_004'].entries()) all.push(await agrees(`${name}.ply`, { time: frame / 5 }));
    assert.ok(relativeDifference(all[1], all[3]) > 0.05, 'the objects move');
    await agrees('low.ply', { time: 0, degree: 3 });
    await agrees('turned.ply', { degree: 6, turn: [Math.cos((20 * Math.PI) / 180), 0, 0, Math.sin((20 * Math.PI) / 180)] });
    await agrees('frames_000.ply', { turn: [1, 0, 0, 0] });
  });
});

test('The space around an object shadows the others as prt relight has it, at centers and vertices', async () => {
  bake('shining', { primitive: 'sphere', albedo: [0.2, 0.2, 0.3], specular: [0.3, 0.3, 0.3], exponent: 8, max_edge: 0.4 }, 3, 'glossy_shadowed', '--plan', 'none');
  for (const [element, degree] of [['single', 2], ['byte', 3]]) {
    prt('volume', 'torus.json', '-o', `around_${element}.transfer`, '--counts', '9,9,7', '--directions', 128, '--element', element, '--degree', degree, '--result-degree', 4);
    const torus = { ...kObjects[0], volume: `around_${element}.transfer` };
    const shining = { transfer: 'shining.transfer', position: [-1.5, -1, 0.5], rotate: { axis: [1, 2, 3], degrees: 50 } };
    writeJson('around.json', { name: 'around', objects: [torus, ...kObjects.slice(1), shining], lights: kLights, camera: kCamera });
    prt('view', 'around.json', '-o', 'around.html');
    const eye = kCamera.position.join(',');
    prt('relight', 'around.json', '-o', 'around.ply', '--frames', 3, '--eye', eye);
    prt('relight', 'around.json', '-o', 'around_low.ply', '--degree', 1, '--eye', eye);
    writeJson('spheres.json', { name: 'spheres', objects: [kObjects[0], ...kObjects.slice(1), shining], lights: kLights });
    prt('relight', 'spheres.json', '-o', 'spheres.ply', '--eye', eye);
    await withPage('around.html', async (page) => {
      for (const [name, state] of [['around_000', { time: 0 }], ['around_001', { time: 1 / 3 }], ['around_002', { time: 2 / 3 }], ['around_low', { time: 0, degree: 1 }]]) {
        await set(page, state);
        const difference = relativeDifference(await radianceOf(page), radianceOfPly(`${name}.ply`));
        console.log(`  ${name}, ${element}: largest difference ${difference.toExponential(2)}`);
        assert.ok(difference <= 2e-6, `${name}: ${difference}`);
      }
      assert.ok(relativeDifference(radianceOfPly('around_000.ply'), radianceOfPly('spheres.ply')) > 0.01, 'the volume matters');
    }, kSize);
  }
  prt('volume', 'torus.json', '-o', 'sent.transfer', '--counts', '3,3,3', '--directions', 64, '--reflected');
  writeJson('sent.json', { objects: [{ ...kObjects[0], volume: 'sent.transfer' }, kObjects[1]] });
  assert.match(refusal('view', 'sent.json', '-o', 'bad.html'), /expected `volume` without `--reflected`$/);
  writeJson('twice.json', { objects: [{ ...kObjects[0], volume: 'around_byte.transfer' }, { ...kObjects[0], position: [9, 9, 9], volume: 'around_byte.transfer' }] });
  assert.match(refusal('view', 'twice.json', '-o', 'bad.html'), /expected one object with `volume`$/);
});

test('A stage plays until it is told to rest', async () => {
  await withPage('stage.html', async (page) => {
    await set(page, { time: 0.99 });
    await page.focus('#view');
    await page.keyboard.press('Space');
    await page.waitForFunction(() => viewer.state.time > 0 && viewer.state.time < 0.9);
    await page.keyboard.press('Space');
    await set(page, {});
    const time = await page.evaluate(() => viewer.state.time);
    await set(page, {});
    assert.equal(await page.evaluate(() => viewer.state.time), time);
    assert.equal(await page.textContent('#name'), 'turning');
  });
});

test('Pictures of a stage are those of prt render', async () => {
  prt('render', 'stage.json', '-o', 'stage.png', '--frames', 2, '--width', kWidth, '--height', kHeight, '--background', 'grey', '--fixed-exposure', 0.5);
  await withPage('stage.html', async (page) => {
    for (const [time, name] of [[0, 'stage_000.png'], [0.5, 'stage_001.png']]) {
      await set(page, { exposure: 0.5, time });
      const difference = rootMeanSquare(await canvasPicture(page), await pictureOf(page, inFolder(name)));
      console.log(`  ${name}: rms ${difference.toFixed(4)}`);
      assert.ok(difference < 0.008, `${name}: rms ${difference}`);
    }
  }, kSize);
});

test('A click tells the vertex of the object under it', async () => {
  await withPage('stage.html', async (page) => {
    await set(page, { exposure: 0.5, time: 0.25 });
    for (const { clicked, told } of await clicksAtCorners(page, 2)) assert.equal(told, clicked);
    await set(page, {});
    const vertex = await page.evaluate(() => viewer.state.vertex);
    const text = await page.textContent('#vertex');
    const radiance = [...(await radianceOf(page))].slice(3 * vertex, 3 * vertex + 3);
    assert.ok(text.includes('ball.transfer') && text.includes(Number(radiance[1].toPrecision(4)).toPrecision(4)), text);
    assert.ok(await page.isVisible('#ball-lobe'));
  }, kSize);
});

test('A stage is compared with another, and with a file', async () => {
  const stage = JSON.parse(fs.readFileSync(inFolder('stage.json'), 'utf8'));
  writeJson('apart.json', { ...stage, objects: stage.objects.map((object) => ({ ...object, proxy: { radius: 0 } })) });
  prt('view', 'stage.json', 'apart.json', 'ball.transfer', '-o', 'compared.html');
  prt('relight', 'apart.json', '-o', 'apart.ply');
  prt('relight', 'ball.transfer', '--light', writeJson('lights.json', kLights), '-o', 'ball.ply');
  await withPage('compared.html', async (page) => {
    assert.equal(await page.evaluate(() => viewer.data.files.length), 4, 'each file once');
    await set(page, { compare: 'difference', a: 0, b: 1 });
    assert.equal(await message(page), '');
    assert.ok(await page.isVisible('#scale'));
    for (const [subject, name] of [[1, 'apart.ply'], [2, 'ball.ply']]) assert.ok(relativeDifference(await radianceOf(page, subject), radianceOfPly(name)) <= 2e-6, name);
    await set(page, { b: 2 });
    assert.ok(!(await page.isVisible('#scale')));
    assert.match(await page.textContent('#comparison'), /different meshes/);
  });
});

test('Transfer files may lie elsewhere, and what does not fit is refused in one line', () => {
  fs.mkdirSync(inFolder('elsewhere'));
  fs.copyFileSync(inFolder('stage.json'), inFolder('elsewhere/stage.json'));
  assert.match(refusal('view', 'elsewhere/stage.json', '-o', 'bad.html'), /^elsewhere\/torus\.transfer: cannot read: /);
  prt('view', 'elsewhere/stage.json', '--transfers', '.', '-o', 'elsewhere.html');
  assert.ok(fs.readFileSync(inFolder('elsewhere.html')).equals(fs.readFileSync(inFolder('stage.html'))));
  writeJson('wrong.json', { objects: [{ transfer: 'floor.transfer', light_at: 'everywhere' }] });
  assert.match(refusal('view', 'wrong.json', '-o', 'bad.html'), /^wrong\.json: \/objects\/0\/light_at: /);
  assert.match(refusal('view', 'stage.json', '-o', 'bad.js'), /^bad\.js: a module relights files like one: expected one transfer file, got stage\.json$/);
  assert.match(refusal('view', 'stage.json', '-o', 'stage.json'), /^stage\.json: expected a name that ends in \.html or \.js$/);
  writeJson('inside.json', { objects: [{ transfer: 'arch.transfer' }, { transfer: 'arch.transfer' }] });
  assert.match(refusal('view', 'inside.json', '--strict', '-o', 'bad.html'), /inside the proxy of object/);
  assert.ok(!fs.existsSync(inFolder('bad.html')));
});

test('Light that shadows bring, and that a file left out, is refused with the words of prt', async () => {
  writeJson('kept.json', { name: 'kept', meshes: [{ primitive: 'plane', transform: { scale: 4 }, max_edge: 0.5 }, { primitive: 'box', transform: { translate: [0, 0, 0.5] }, max_edge: 0.5 }],
                           lights: [{ type: 'cie_overcast' }], bake: { degree: 4, directions: 128 } });
  prt('bake', 'kept.json', '-o', 'kept.transfer', '--no-checkpoint', '--plan', 'lossy', '--error', 0.01, '--without', 'bands,directions');
  assert.ok(JSON.parse(prt('info', 'kept.transfer')).storage.kept.length < 25);
  for (const lightAt of ['vertices', 'center']) {
    writeJson('lacking.json', { lights: [{ type: 'cie_overcast' }], objects: [{ transfer: 'kept.transfer', light_at: lightAt }, { transfer: 'ball.transfer', position: [7, 1, 2] }] });
    const words = refusal('relight', 'lacking.json', '-o', 'lacking.ply');
    prt('view', 'lacking.json', '-o', 'lacking.html');
    await withPage('lacking.html', async (page) => assert.equal((await message(page)).replace(/^lacking\.json: /, ''), words, lightAt));
  }
});
