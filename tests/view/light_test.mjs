// Files as lights of a page: given at export, dropped on it, or sent to the server of `prt view --serve`.
import assert from 'node:assert';
import fs from 'node:fs';
import { before, test } from 'node:test';
import { drop, inFolder, message, prt, radianceOf, radianceOfPly, refusal, relativeDifference, scene, set, spawnPrt, statusOf, withAddress, withPage } from './browser.mjs';
import { rgbeNoise, rgbeSky, writeExr, writeExrAs, writeHdr, writeOldHdr } from './light_pictures.mjs';

const kWidth = 64;
const kSky = rgbeSky(kWidth);

before(() => {
  scene('box.json', { bake: { directions: 128 } });
  prt('bake', 'box.json', '-o', 'box.transfer', '--no-checkpoint', '--plan', 'none');
  prt('view', 'box.transfer', '-o', 'box.html');
  writeHdr('sky.hdr', kWidth, kSky);
  writeHdr('plain.hdr', kWidth, kSky, { isEncoded: false, lines: ['EXPOSURE=2', '# a comment', 'EXPOSURE=0.25'] });
  writeOldHdr('old.hdr');
  writeHdr('narrow.hdr', 4, rgbeSky(4), { isEncoded: false });
  writeExr('sky.exr', kWidth, kSky);
});

const coefficientsOf = (name, degree = 4) => JSON.parse(prt('project', name, '--degree', degree)).coefficients.flat();

async function isDropped(page, name) {
  await drop(page, name, fs.readFileSync(inFolder(name)));
  await page.waitForFunction((file) => viewer.lighting.dropped?.name === file, name);
  await set(page, {});
  assert.equal(await message(page), '');
  assert.equal(await page.evaluate(() => viewer.state.light), 'dropped');
  return page.evaluate(() => [...viewer.lighting.dropped.light.values]);
}

test('A picture in .hdr that is dropped on the page is the light of prt project', async () => {
  await withPage('box.html', async (page) => {
    for (const name of ['sky.hdr', 'plain.hdr', 'old.hdr', 'narrow.hdr']) {
      const difference = relativeDifference(await isDropped(page, name), coefficientsOf(name));
      console.log(`  ${name}: largest difference ${difference.toExponential(2)}`);
      assert.ok(difference < 1e-6, `${name}: ${difference}`);
      prt('relight', 'box.transfer', '--light', name, '-o', 'dropped.ply');
      assert.ok(relativeDifference(await radianceOf(page), radianceOfPly('dropped.ply')) <= 2e-6, name);
    }
    assert.ok(Math.abs(coefficientsOf('plain.hdr')[0] / coefficientsOf('sky.hdr')[0] - 2) < 1e-6, 'exposures divide');
  });
});

// Even and odd counts of lines, chunks that are not full, more values than 2^14; some channels are no color.
test('A picture in .exr of any compression that the page reads is the light of prt project', async () => {
  await withPage('box.html', async (page) => {
    for (const width of [2, 10, 66, 600]) {
      writeExr('noise.exr', width, rgbeNoise(width));
      for (const compression of width < 600 ? [0, 1, 2, 3, 4] : [3, 4]) {
        for (const [type, order] of [['half', 'decreasing'], ['float', 'increasing']]) {
          const name = writeExrAs('noise.exr', `${width}_${compression}_${type}.exr`, compression, type, order);
          const difference = relativeDifference(await isDropped(page, name), coefficientsOf(name));
          assert.ok(difference < 1e-6, `${name}: ${difference}`);
        }
      }
    }
  });
});

test('Pictures in .exr that are damaged, or that the page does not read, are refused with one line', async () => {
  writeExr('noise.exr', 34, rgbeNoise(34));
  const packed = (compression) => fs.readFileSync(inFolder(writeExrAs('sky.exr', 'packed.exr', compression, 'half', 'increasing')));
  const plain = fs.readFileSync(inFolder('noise.exr'));
  const set32 = (bytes, at, value) => { const out = Buffer.from(bytes); out.writeInt32LE(value, at); return out; };
  const whereOf = (bytes, key) => bytes.indexOf(`${key}\0`) + bytes.subarray(bytes.indexOf(`${key}\0`) + key.length + 1).indexOf(0) + key.length + 2 + 4;
  const lastPixel = plain.length - 4;
  const flipped = (bytes, at) => Buffer.from(bytes.map((byte, i) => (i === at ? byte ^ 0xff : byte)));
  const cases = [
    ['no.exr', Buffer.from('no picture'), /does not begin as OpenEXR/], ['half.exr', plain.subarray(0, plain.length / 2), /is truncated/],
    ['head.exr', plain.subarray(0, 40), /is truncated/], ['tiles.exr', set32(plain, 4, 0x202), /has tiles, several parts or deep pixels/],
    ['size.exr', set32(plain, whereOf(plain, 'dataWindow') + 8, 1 << 30), /^size\.exr: the picture is 1073741825 x 17 pixels; expected 1 to 134217728 pixels$/],
    ['type.exr', set32(plain, whereOf(plain, 'channels') + 2, 7), /has a channel of the unknown type 7/],
    ['names.exr', Buffer.from(plain.map((byte, i) => (i === whereOf(plain, 'channels') ? 67 : byte))), /^names\.exr: has the channels C, G, R; expected R, G, B in one layer, or Y alone$/],
    ['sampled.exr', set32(plain, whereOf(plain, 'channels') + 10, 2), /the channel B is subsampled; expected a value for every pixel/],
    ['nan.exr', set32(plain, lastPixel, 0x7fc00000), /^nan\.exr: the pixel in column 33, row 16 is \(nan, .*\); expected finite values$/],
    ['zlib.exr', flipped(packed(3), packed(3).length - 100), /has a chunk that is no zlib stream of its size/],
    ['runs.exr', packed(1).fill(127, packed(1).length - 200), /has wrong run lengths|has too few run lengths/],
    ['piz.exr', packed(4).fill(255, packed(4).length - 2000), /expected a complete OpenEXR picture/],
    ['dwaa.exr', packed(8), /^dwaa\.exr: is compressed by DWAA, which `prt project` reads; this page reads plain pictures, run lengths, zlib and PIZ$/],
  ];
  await withPage('box.html', async (page) => {
    for (const [name, bytes, line] of cases) {
      await drop(page, name, bytes);
      await page.waitForFunction((start) => document.getElementById('message').textContent.startsWith(start) || viewer.lighting.dropped, name);
      assert.equal(await page.evaluate(() => viewer.state.light), 'given', name);
      assert.match(await message(page), line, name);
    }
  });
});

test('Negative pixels are 0 and told, as prt warns of them', async () => {
  writeExr('noise.exr', 10, rgbeNoise(10));
  const bytes = fs.readFileSync(inFolder('noise.exr'));
  bytes.writeFloatLE(-1, bytes.length - 4);
  fs.writeFileSync(inFolder('negative.exr'), bytes);
  await withPage('box.html', async (page) => {
    await drop(page, 'negative.exr', bytes);
    await page.waitForFunction(() => viewer.lighting.dropped);
    await set(page, {});
    assert.equal(await message(page), 'negative.exr: 1 of 50 pixels are negative in some channel (set to 0)');
    assert.ok(relativeDifference(await page.evaluate(() => [...viewer.lighting.dropped.light.values]), coefficientsOf('negative.exr')) < 1e-6);
    await set(page, { light: 'given' });
    assert.equal(await message(page), '');
  });
});

test('A file that is chosen, not dropped, is the light, too', async () => {
  await withPage('box.html', async (page) => {
    await page.setInputFiles('#control-file', inFolder('sky.hdr'));
    await page.waitForFunction(() => viewer.state.light === 'dropped');
    assert.ok(relativeDifference(await page.evaluate(() => [...viewer.lighting.dropped.light.values]), coefficientsOf('sky.hdr')) < 1e-6);
  });
});

test('Pictures that are damaged or do not fit are refused with the words of prt', async () => {
  const bytes = fs.readFileSync(inFolder('sky.hdr'));
  const text = (change) => Buffer.concat([Buffer.from(change(bytes.subarray(0, 100).toString('latin1')), 'latin1'), bytes.subarray(100)]);
  const rows = bytes.indexOf('+X 64\n') + 6;
  const changed = (at, value) => Buffer.from(bytes.map((byte, i) => (i === at ? value : byte)));
  const cases = [['half', bytes.subarray(0, bytes.length / 2)], ['header', bytes.subarray(0, 20)], ['format', text((all) => all.replace('rle_rgbe', 'rle_xyze'))],
                 ['none', text((all) => all.replace('FORMAT', 'FORMAL'))], ['exposure', text((all) => all.replace('FORMAT', 'EXPOSURE=-1\nFORMAT'))],
                 ['size', text((all) => all.replace('-Y 32 +X 64', '+Y 32 +X 64'))], ['shape', text((all) => all.replace('-Y 32 +X 64', '-Y 16 +X 64'))],
                 ['length', changed(rows + 3, 65)], ['run', changed(rows + 4, 255)]];
  await withPage('box.html', async (page) => {
    for (const [what, damaged] of cases) {
      fs.writeFileSync(inFolder('bad.hdr'), damaged);
      await drop(page, 'bad.hdr', damaged);
      await page.waitForFunction(() => !document.getElementById('message').hidden);
      assert.equal(await message(page), refusal('project', 'bad.hdr'), what);
      assert.equal(await page.evaluate(() => viewer.state.light), 'given');
      await set(page, {});
    }
    for (const [name, content, line] of [
      ['c.png', '', /^c\.png: of pictures this page reads \.hdr and \.exr: drop the JSON of `prt project c\.png --degree 4`, or open the page with `prt view --serve`$/],
      ['d.txt', 'light', /^d\.txt: expected a light: the JSON of `prt project`, or a lat-long picture$/],
      ['e.json', JSON.stringify({ degree: 0, coefficients: [[1e300], [0], [0]] }), /^e\.json: the lights exceed single precision; expected weaker ones, below 1e37$/],
    ]) {
      await drop(page, name, Buffer.from(content));
      await page.waitForFunction((start) => document.getElementById('message').textContent.startsWith(start), name);
      assert.match(await message(page), line);
    }
  });
});

test('A picture that is given at export is the light of the page', async () => {
  for (const name of ['sky.hdr', 'sky.exr']) {
    prt('view', 'box.transfer', '--light', name, '--turn', 70, '-o', 'given.html');
    prt('relight', 'box.transfer', '--light', name, '--turn', 70, '-o', 'given.ply');
    await withPage('given.html', async (page) => {
      assert.ok(relativeDifference(await radianceOf(page), radianceOfPly('given.ply')) <= 2e-6, name);
      assert.equal(await page.evaluate(() => document.querySelector('#control-light option').textContent), 'sky');
    });
  }
  assert.match(refusal('view', 'box.transfer', '--light', 'narrow.exr', '-o', 'bad.html'), /^narrow\.exr: /);
});

test('The server of a page reads every picture, and refuses in the words of prt', async () => {
  const server = spawnPrt('view', 'box.transfer', '--serve');
  try {
    const address = await server.line(/http:\/\/127\.0\.0\.1:\d+\//);
    await withAddress(address, async (page) => {
      assert.ok(relativeDifference(await isDropped(page, 'sky.exr'), coefficientsOf('sky.exr')) < 1e-12);
    });
    const answer = await fetch(`${address}project?degree=4`, { method: 'POST', body: Buffer.from('no picture') });
    fs.writeFileSync(inFolder('no.exr'), 'no picture');
    assert.equal(answer.status, 400);
    assert.equal(`no.exr: ${await answer.text()}`, refusal('project', 'no.exr'));
    assert.equal((await fetch(`${address}project?degree=99`, { method: 'POST', body: kSky })).status, 400);
    assert.equal((await fetch(`${address}project`, { method: 'POST', body: kSky })).status, 400);
    assert.equal(await statusOf(`${address}project`, '127.0.0.1'), 404);
    assert.equal(await statusOf(address, '127.0.0.1', { origin: 'http://elsewhere.test' }), 403);
  } finally {
    assert.equal(await server.end(), 0);
  }
});
