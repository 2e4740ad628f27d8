// What the page does: its pictures beside `prt render`, dragging, comparing, inspecting, the fragment, bad input.
import assert from 'node:assert';
import fs from 'node:fs';
import { before, test } from 'node:test';
import { clicksAtCorners, drop, inFolder, message, pageWith, prt, radianceOf, radianceOfPly, refusal, relativeDifference, scene, set, spawnPrt, statusOf, withAddress, withPage, writeJson } from './browser.mjs';
import { canvasPicture, pictureOf, rootMeanSquare } from './pictures.mjs';

const kCamera = { position: [4, -4, 3], target: [0.2, 0, 0.3], field_of_view: 40 };
const kSky = [{ type: 'cie_sky', sky: 12, sun: { elevation: 40, azimuth: -60 }, radiance: [0.5, 0.7, 1] }];
const kLimit = 0.008;  // of pictures; seen: 0.0027
const kWidth = 480, kHeight = 320;  // of the canvas
const kSize = { width: kWidth + 312, height: kHeight };  // of the page: its panel is beside the canvas

before(() => {
  for (const [name, kind] of [['shadowed', 'shadowed'], ['bounced', 'interreflected'], ['glossy', 'glossy_shadowed']]) {
    const mesh = name === 'glossy' ? { specular: [0.19, 0.19, 0.19], exponent: 12 } : {};
    scene(`${name}.json`, { mesh: { max_edge: 0.25, ...mesh }, lights: kSky, camera: kCamera });
    prt('bake', `${name}.json`, '-o', `${name}.transfer`, '--kind', kind, '--plan', 'none', '--no-checkpoint');
    prt('view', `${name}.transfer`, '--scene', `${name}.json`, '-o', `${name}.html`);
  }
  prt('view', 'shadowed.transfer', 'bounced.transfer', '--scene', 'shadowed.json', '-o', 'two.html');
});

const render = (name, out, ...words) => prt('render', `${name}.transfer`, '--scene', `${name}.json`, '-o', out, '--width', kWidth, '--height', kHeight, ...words);

test('Pictures are those of prt render, for each tone curve and exposure', async () => {
  for (const [name, limit] of [['shadowed', kLimit], ['bounced', kLimit], ['glossy', kLimit]]) {
    await withPage(`${name}.html`, async (page) => {
      for (const tone of ['neutral', 'reinhard', 'linear']) {
        render(name, 'picture.png', '--fixed-exposure', 0.5, '--exposure', 0.5, '--tone', tone, '--background', 'grey');
        await set(page, { exposure: 0.5, stops: 0.5, tone });
        const difference = rootMeanSquare(await canvasPicture(page), await pictureOf(page, inFolder('picture.png')));
        console.log(`  ${name}, ${tone}: rms ${difference.toFixed(4)}`);
        assert.ok(difference < limit, `${name}, ${tone}: rms ${difference}`);
      }
    }, kSize);
  }
});

test('The measured exposure is that of prt render', async () => {
  render('shadowed', 'auto.png');
  await withPage('shadowed.html', async (page) => {
    const difference = rootMeanSquare(await canvasPicture(page), await pictureOf(page, inFolder('auto.png')));
    assert.ok(difference < kLimit, `rms ${difference}`);
  }, kSize);
});

// A unit quaternion as the rotation of a light in a scene.
function rotationOf([w, x, y, z]) {
  const sine = Math.hypot(x, y, z);
  return { axis: [x / sine, y / sine, z / sine], degrees: (2 * Math.atan2(sine, w) * 180) / Math.PI };
}

async function drag(page, from, to, { shift = false } = {}) {
  if (shift) await page.keyboard.down('Shift');
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  await page.mouse.move(...to);
  await page.mouse.up();
  if (shift) await page.keyboard.up('Shift');
  await set(page, {});
}

test('Dragging with shift turns the light as prt turns it', async () => {
  await withPage('shadowed.html', async (page) => {
    await set(page, { exposure: 0.5 });
    const before = await canvasPicture(page);
    await drag(page, [100, 200], [200, 200], { shift: true });
    prt('relight', 'shadowed.transfer', '--scene', 'shadowed.json', '--turn', 40, '-o', 'turned.ply');
    assert.ok(relativeDifference(await radianceOf(page), radianceOfPly('turned.ply')) < 2e-6);
    await drag(page, [100, 200], [150, 120], { shift: true });
    const turn = rotationOf(await page.evaluate(() => viewer.state.turn));
    prt('relight', 'shadowed.transfer', '--light', writeJson('turned.json', [{ ...kSky[0], rotate: turn }]), '-o', 'turned.ply');
    assert.ok(relativeDifference(await radianceOf(page), radianceOfPly('turned.ply')) < 2e-6);
    const turned = JSON.parse(fs.readFileSync(inFolder('shadowed.json'), 'utf8'));
    writeJson('turned-scene.json', { ...turned, lights: [{ ...kSky[0], rotate: turn }] });
    prt('render', 'shadowed.transfer', '--scene', 'turned-scene.json', '--fixed-exposure', 0.5, '-o', 'turned.png', '--width', kWidth, '--height', kHeight, '--background', 'grey');
    const after = await canvasPicture(page);
    assert.ok(rootMeanSquare(before, after) > 0.02, 'the picture changes');
    assert.ok(rootMeanSquare(after, await pictureOf(page, inFolder('turned.png'))) < kLimit);
  }, kSize);
});

test('Dragging orbits, the wheel zooms, keys do both', async () => {
  await withPage('shadowed.html', async (page) => {
    const state = () => page.evaluate(() => ({ ...viewer.state }));
    const first = await state();
    await drag(page, [200, 200], [250, 220]);
    const dragged = await state();
    assert.ok(Math.abs(dragged.yaw - (first.yaw - 20)) < 1e-6 && Math.abs(dragged.pitch - (first.pitch + 8)) < 1e-6);
    const zooms = (before) => page.waitForFunction((distance) => viewer.state.distance < distance, before, { timeout: 5000 });
    do await page.mouse.wheel(0, -200);  // a busy browser drops some
    while (!(await zooms(first.distance).catch(() => false)));
    await page.focus('#view');
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('Shift+ArrowRight');
    const pressed = await state();
    assert.ok(pressed.yaw !== dragged.yaw);
    assert.ok(Math.abs(pressed.turn[3] - Math.sin((2.5 * Math.PI) / 180)) < 1e-12);
    await page.keyboard.press('z');
    assert.deepEqual(await state(), first);
  });
});

test('Two fingers zoom and turn the light', async () => {
  await withPage('shadowed.html', async (page) => {
    const first = await page.evaluate(() => ({ ...viewer.state }));
    const session = await page.context().newCDPSession(page);
    const touch = (type, points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    await touch('touchStart', [[150, 100], [200, 100]]);
    await touch('touchMove', [[140, 110], [230, 110]]);
    await touch('touchMove', [[130, 120], [260, 120]]);
    await touch('touchEnd', []);
    const then = await page.evaluate(() => ({ ...viewer.state }));
    assert.ok(then.distance < first.distance && then.turn[0] < 1);
    assert.equal(then.yaw, first.yaw);
    await touch('touchStart', [[150, 100]]);
    await touch('touchMove', [[190, 100]]);
    await touch('touchEnd', []);
    assert.ok(await page.evaluate((yaw) => viewer.state.yaw !== yaw, first.yaw));
  }, { width: 390, height: 760, hasTouch: true, isMobile: true });
});

test('A wipe shows two files side by side, and moves', async () => {
  await withPage('two.html', async (page) => {
    await set(page, { exposure: 0.5 });
    const first = await canvasPicture(page);
    await set(page, { a: 1 });
    const second = await canvasPicture(page);
    await set(page, { a: 0, b: 1, compare: 'wipe', wipe: 0.25 });
    await page.addStyleTag({ content: '#divider { opacity: 0; }' });
    const both = await canvasPicture(page);
    const left = (i) => Math.floor(i / 3) % kWidth < 0.25 * kWidth - 2, right = (i) => Math.floor(i / 3) % kWidth > 0.25 * kWidth + 2;
    assert.ok(rootMeanSquare(first, second) > 0.005, 'the files look different');
    for (const [side, of] of [[left, first], [right, second]]) {
      assert.ok(both.rgb.every((value, i) => !side(i) || Math.abs(value - of.rgb[i]) < 0.01));
    }
    const line = await page.locator('#divider').boundingBox();
    await page.mouse.move(line.x + 8, 50);
    await page.mouse.down();
    await page.mouse.move(300, 50);
    await page.mouse.up();
    assert.ok(Math.abs((await page.evaluate(() => viewer.state.wipe)) - 300 / kWidth) < 1e-3);
  }, kSize);
});

test('The difference of a file from itself is dark, from another is not', async () => {
  await withPage('two.html', async (page) => {
    await page.addStyleTag({ content: '#scale { display: none !important; }' });
    await set(page, { compare: 'difference', b: 0, balls: false });
    const middle = (picture) => picture.rgb.slice(3 * (Math.floor(kHeight / 2) * kWidth + kWidth / 2), 3 * (Math.floor(kHeight / 2) * kWidth + kWidth / 2) + 3);
    assert.ok(Math.max(...middle(await canvasPicture(page))) < 0.15);
    await set(page, { b: 1 });
    assert.ok(Math.max(...middle(await canvasPicture(page))) > 0.3);
  }, kSize);
});

test('A click tells the vertex under it: its numbers and its radiance', async () => {
  await withPage('bounced.html', async (page) => {
    await page.mouse.click(kWidth / 2, kHeight / 2);
    await set(page, {});
    const vertex = await page.evaluate(() => viewer.state.vertex);
    assert.ok(vertex >= 0);
    const radiance = [...(await radianceOf(page))].slice(3 * vertex, 3 * vertex + 3);
    const text = await page.textContent('#vertex');
    assert.ok(text.includes(String(vertex)) && text.includes(Number(radiance[0].toPrecision(4)).toPrecision(4)));
    assert.equal(await page.locator('#vertex .bars li').count(), 75);
    const marker = await page.locator('#marker').boundingBox();
    assert.ok(Math.hypot(marker.x + 9 - kWidth / 2, marker.y + 9 - kHeight / 2) < 20, 'the marker is near the click');
    assert.ok(await page.isVisible('#ball-lobe'));
  }, kSize);
});

test('A click tells the nearest of the three corners of the face under it', async () => {
  writeJson('ball.json', { name: 'ball', meshes: [{ primitive: 'sphere', max_edge: 0.4 }], bake: { degree: 2, directions: 64 } });
  prt('bake', 'ball.json', '-o', 'ball.transfer', '--no-checkpoint');
  prt('view', 'ball.transfer', '-o', 'ball.html');
  await withPage('ball.html', async (page) => {
    for (const pitch of [40, -40]) {  // from above and below: of the two faces under a click, the front is the first or the second
      await set(page, { pitch });
      const clicks = await clicksAtCorners(page);
      assert.equal(clicks.length, 24);
      for (const { clicked, told } of clicks) assert.equal(told, clicked);
    }
    await page.mouse.click(3, 30);
    assert.equal(await page.evaluate(() => viewer.state.vertex), -1, 'nothing is there');
  }, kSize);
});

test('The fragment restores the view', async () => {
  const shown = await withPage('two.html', async (page) => {
    await set(page, { light: 'cap', elevation: 30, halfAngle: 20, window: 'hann', strength: 0.3, degree: 3, yaw: 10, pitch: 50, compare: 'wipe', wipe: 0.4, stops: -1, vertex: 5, turn: [0.8, 0, 0.6, 0] });
    await page.waitForFunction(() => location.hash.includes('turn'));
    return page.evaluate(() => ({ hash: location.hash, state: viewer.state, light: [...viewer.lighting.of(viewer.state).values] }));
  });
  await withPage('two.html', async (page) => {
    const again = await page.evaluate(() => ({ hash: location.hash, state: viewer.state, light: [...viewer.lighting.of(viewer.state).values] }));
    assert.deepEqual(again.state, shown.state);
    assert.deepEqual(again.light, shown.light);
  }, { hash: shown.hash });
  await withPage('two.html', async (page) => {
    const state = await page.evaluate(() => viewer.state);
    assert.deepEqual([state.degree, state.yaw, state.a, state.window], [4, await page.evaluate(() => viewer.begin.yaw), 1, 'none']);
  }, { hash: '#degree=99&yaw=high&a=7&nothing=1&window=none&turn=1,2' });
});

test('Coefficients of prt project that are dropped on the page light it', async () => {
  writeJson('sky.json', [{ ...kSky[0], sun: { elevation: 20, azimuth: 100 } }]);  // not the light of the page
  const json = prt('project', 'sky.json', '--degree', 4);
  prt('relight', 'bounced.transfer', '--light', 'sky.json', '-o', 'dropped.ply');
  await withPage('bounced.html', async (page) => {
    await set(page, { light: 'cap' });
    await drop(page, 'sky.json', json);
    await page.waitForFunction(() => viewer.state.light === 'dropped');
    assert.ok(relativeDifference(await radianceOf(page), radianceOfPly('dropped.ply')) < 2e-6);
    for (const [name, text, line] of [
      ['a.json', '{"degree": 4}', 'a.json: not a light: expected the JSON of `prt project LIGHT --degree N`, three channels of (N+1)^2 coefficients'],
      ['b.json', '{', 'b.json: not JSON: '],
    ]) {
      await drop(page, name, text);
      await page.waitForFunction((part) => document.getElementById('message').textContent.startsWith(part), line);
      await set(page, { yaw: name === 'a.json' ? 20 : 40 });
      assert.ok((await message(page)).startsWith(line), 'it stays when the view turns');
    }
    await set(page, { light: 'cap' });
    assert.equal(await message(page), '', 'another light needs no word');
  });
});

test('A changed byte is refused with the words of prt', async () => {
  const bytes = fs.readFileSync(inFolder('bounced.transfer'));
  const headerAt = 48 + 40 * bytes.readUInt32LE(12);
  const sections = Array.from({ length: bytes.readUInt32LE(12) }, (_, k) => Number(bytes.readBigUInt64LE(48 + 40 * k + 24)));
  const changes = [['magic', 0], ['version', 8], ['sections', 12], ['size', 16], ['header size', 25], ['header checksum', 33], ['checksum', 41],
                   ['name in the table', 50], ['header', headerAt + 5], ...sections.map((at, k) => [`section ${k}`, at + 6]), ['last byte', bytes.length - 1]];
  const cases = [...changes.map(([what, at]) => [what, Buffer.from(bytes.map((byte, i) => (i === at ? byte ^ 4 : byte)))]),
                 ['half of it', bytes.subarray(0, bytes.length / 2)], ['ten bytes', bytes.subarray(0, 10)], ['no transfer file', Buffer.alloc(100, 'x')], ['more bytes', Buffer.concat([bytes, Buffer.alloc(3)])]];
  for (const [what, damaged] of cases) {
    fs.writeFileSync(inFolder('bounced.transfer.bad'), damaged);
    const words = refusal('info', 'bounced.transfer.bad', '--check').replace('bounced.transfer.bad', 'bounced.transfer');
    pageWith('bounced.html', 'damaged.html', damaged);
    await withPage('damaged.html', async (page) => assert.equal(await message(page), words, what));
  }
});

test('A page that is damaged itself says so', async () => {
  const html = fs.readFileSync(inFolder('bounced.html'), 'utf8');
  const at = html.indexOf('"data":"H4sI') + 400;
  fs.writeFileSync(inFolder('broken.html'), html.slice(0, at) + (html[at] === 'A' ? 'B' : 'A') + html.slice(at + 1));
  await withPage('broken.html', async (page) => {
    assert.match(await message(page), /^bounced\.transfer: (the page is damaged where it holds this file|damaged transfer file)/);
  });
});

// A copy of a page in which the GPU has another limit.
function withLimit(from, to, name, value) {
  const script = `const of = WebGL2RenderingContext.prototype.getParameter; WebGL2RenderingContext.prototype.getParameter = function (name) { return name === this.${name} ? ${value} : of.call(this, name); };`;
  fs.writeFileSync(inFolder(to), fs.readFileSync(inFolder(from), 'utf8').replace('<body>', () => `<body><script>${script}</script>`));
}

test('Numbers fill the textures that a GPU has; more of them are refused, with the limit', async () => {
  prt('relight', 'shadowed.transfer', '--scene', 'shadowed.json', '-o', 'small.ply');
  const { vertices } = JSON.parse(prt('info', 'shadowed.transfer'));
  const side = 2 ** Math.ceil(Math.log2(Math.sqrt((25 * vertices) / 4)));
  withLimit('shadowed.html', 'small.html', 'MAX_TEXTURE_SIZE', side);
  await withPage('small.html', async (page) => assert.ok(relativeDifference(await radianceOf(page), radianceOfPly('small.ply')) < 2e-6));
  withLimit('shadowed.html', 'small.html', 'MAX_TEXTURE_SIZE', side / 2);
  await withPage('small.html', async (page) => assert.match(await message(page), new RegExp(
    `^shadowed\\.transfer: its numbers \\(transfer\\) need a texture of ${side} x \\d+, this GPU has at most ${side / 2} x ${side / 2}: bake fewer vertices, a lower degree, or clusters \\(\`--compress 128 8\`\\)$`)));
});

test('Where a GPU hands on few numbers, glossy pixels take radiance from between the vertices', async () => {
  withLimit('glossy.html', 'few.html', 'MAX_VARYING_VECTORS', 15);
  render('glossy', 'few.png', '--fixed-exposure', 0.5, '--background', 'grey');
  const shade = (name) => withPage(name, async (page) => {
    await set(page, { exposure: 0.5 });
    const shown = await canvasPicture(page);
    return { shown, difference: rootMeanSquare(shown, await pictureOf(page, inFolder('few.png'))) };
  }, kSize);
  const [vertices, pixels] = [await shade('few.html'), await shade('glossy.html')];
  assert.ok(vertices.difference < 2 * kLimit && pixels.difference < vertices.difference, `${vertices.difference}, ${pixels.difference}`);
});

test('A browser without WebGL 2 is named', async () => {
  fs.writeFileSync(inFolder('old.html'), fs.readFileSync(inFolder('shadowed.html'), 'utf8').replace('<body>', () => '<body><script>HTMLCanvasElement.prototype.getContext = () => null;</script>'));
  await withPage('old.html', async (page) => assert.equal(await message(page), 'this browser has no WebGL 2, which the page needs: use a newer one, or switch graphics acceleration on'));
});

test('Light that a file left out is refused with the words of prt', async () => {
  scene('kept.json', { lights: [{ type: 'cie_overcast' }] });
  prt('bake', 'kept.json', '-o', 'kept.transfer', '--no-checkpoint', '--plan', 'lossy', '--error', 0.01, '--without', 'bands,directions');
  prt('view', 'kept.transfer', '-o', 'kept.html');
  writeJson('cap.json', [{ type: 'cap', direction: { elevation: 40, azimuth: -120 }, half_angle: 10, irradiance: [3, 3, 3] }]);
  const words = refusal('relight', 'kept.transfer', '--light', 'cap.json', '-o', 'kept.ply');
  await withPage('kept.html', async (page) => {
    await set(page, { light: 'cap' });
    assert.equal(await message(page), words.startsWith('kept.transfer') ? words : `kept.transfer: ${words}`);
    await set(page, { light: 'given' });
    assert.equal(await message(page), '');
  });
});

test('prt view refuses bad input in one line and writes nothing', () => {
  const nothing = (name) => assert.ok(!fs.existsSync(inFolder(name)));
  fs.writeFileSync(inFolder('text.transfer'), 'no transfer file, but text that is longer than its prologue');
  assert.match(refusal('view', 'text.transfer', '-o', 'bad.html'), /^text\.transfer: not a transfer file: it does not begin with `shprt`$/);
  assert.match(refusal('view', 'shadowed.transfer', '-o', 'bad.png'), /^bad\.png: expected a name that ends in \.html or \.js$/);
  assert.match(refusal('view', 'shadowed.transfer', 'bounced.transfer', '-o', 'bad.js'), /^bad\.js: a module relights files like one: expected one transfer file, got shadowed\.transfer, bounced\.transfer$/);
  assert.match(refusal('view', 'missing.transfer', '-o', 'bad.html'), /^missing\.transfer: cannot read: /);
  nothing('bad.html');
  nothing('bad.js');
});

test('One lobe for all surfaces is that of a file which was baked with it', async () => {
  scene('other.json', { mesh: { max_edge: 0.25, specular: [0.1, 0.1, 0.1], exponent: 40 }, lights: kSky, camera: kCamera });
  prt('bake', 'other.json', '-o', 'other.transfer', '--kind', 'glossy_shadowed', '--plan', 'none', '--no-checkpoint');
  prt('relight', 'other.transfer', '--scene', 'other.json', '-o', 'other.ply');
  await withPage('glossy.html', async (page) => {
    const before = await radianceOf(page);
    await set(page, { ownSurface: true, exponent: 40, specular: 0.1 });
    const shiny = await page.evaluate(() => [...viewer.subjects[0].objects[0].transfer.sections.specular]);
    const [own, baked] = [await radianceOf(page), radianceOfPly('other.ply')].map((values) => values.filter((_, i) => shiny[i] > 0));
    assert.ok(own.length > 300 && relativeDifference(own, baked) < 2e-6);
    assert.ok(relativeDifference(own, before.filter((_, i) => shiny[i] > 0)) > 1e-3);
    await set(page, { ownSurface: false });
    assert.ok(relativeDifference(await radianceOf(page), before) === 0);
  }, kSize);
});

test('One lobe for all surfaces stays beside a file without lobes', async () => {
  prt('view', 'glossy.transfer', 'shadowed.transfer', '--scene', 'glossy.json', '-o', 'beside.html');
  await withPage('beside.html', async (page) => {
    await set(page, { exposure: 0.5 });
    const before = await canvasPicture(page);
    await set(page, { ownSurface: true, exponent: 40, specular: 0.4 });
    const alone = await canvasPicture(page);
    assert.ok(rootMeanSquare(before, alone) > 0.02);
    await set(page, { compare: 'wipe', wipe: 0.9 });
    await page.addStyleTag({ content: '#divider { display: none; }' });
    const both = await canvasPicture(page);
    assert.ok(both.rgb.every((value, i) => Math.floor(i / 3) % kWidth > 0.9 * kWidth - 2 || Math.abs(value - alone.rgb[i]) < 0.01));
  }, kSize);
});

test('A served page shows the same, and answers to no other name', async () => {
  const server = spawnPrt('view', 'shadowed.transfer', '--scene', 'shadowed.json', '--serve');
  try {
    const address = await server.line(/http:\/\/127\.0\.0\.1:\d+\//);
    prt('relight', 'shadowed.transfer', '--scene', 'shadowed.json', '-o', 'served.ply');
    await withAddress(address, async (page) => assert.ok(relativeDifference(await radianceOf(page), radianceOfPly('served.ply')) < 2e-6));
    assert.equal(await statusOf(address, 'elsewhere.test'), 403);
    assert.equal(await statusOf(`${address}file/1`, '127.0.0.1'), 404);
  } finally {
    assert.equal(await server.end(), 0);
  }
});

test('Two writings of one page have the same bytes', () => {
  prt('view', 'shadowed.transfer', '--scene', 'shadowed.json', '-o', 'again.html', '--threads', 1);
  assert.ok(fs.readFileSync(inFolder('again.html')).equals(fs.readFileSync(inFolder('shadowed.html'))));
});
