// Pictures of light that the tests write: Radiance .hdr, encoded or plain, and OpenEXR, plain or by the OpenEXR library.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import { inFolder, kBin } from './browser.mjs';

/** A sky of `width` x width / 2 pixels as RGBE: smooth colors, a few bright pixels, rows of one color. */
export function rgbeSky(width) {
  const height = width / 2;
  return Buffer.from(Array.from({ length: width * height }, (_, k) => {
    const [column, row] = [k % width, Math.floor(k / width)];
    if (row === 5 && column > 10 && column < 14) return [250, 240, 200, 138];
    return row > height / 2 ? [90, 80, 70, 127] : [128 + ((row * 7) % 100), (40 + 3 * column) % 256, 200 - row, 128];
  }).flat());
}

function encodedRow(pixels) {
  const width = pixels.length / 4;
  const out = [2, 2, width >> 8, width & 255];
  for (let channel = 0; channel < 4; ++channel) {
    for (let i = 0; i < width;) {
      let run = 1;
      while (i + run < width && run < 127 && pixels[4 * (i + run) + channel] === pixels[4 * i + channel]) ++run;
      if (run > 2) {
        out.push(128 + run, pixels[4 * i + channel]);
        i += run;
      } else {
        const count = Math.min(width - i, 5);
        out.push(count, ...Array.from({ length: count }, (_, k) => pixels[4 * (i + k) + channel]));
        i += count;
      }
    }
  }
  return Buffer.from(out);
}

/** Writes a picture of RGBE pixels; `lines` go into the header. */
export function writeHdr(name, width, rgbe, { isEncoded = true, lines = [] } = {}) {
  const height = rgbe.length / 4 / width;
  const head = Buffer.from(['#?RADIANCE', 'FORMAT=32-bit_rle_rgbe', ...lines, '', `-Y ${height} +X ${width}`, ''].join('\n'));
  const rows = Array.from({ length: height }, (_, row) => rgbe.subarray(4 * width * row, 4 * width * (row + 1)));
  fs.writeFileSync(inFolder(name), Buffer.concat([head, ...rows.map((row) => (isEncoded ? encodedRow(row) : row))]));
  return name;
}

/** Writes 600 x 300 pixels in the old style: the first row repeats its first pixel 87 + 2 * 256 times. */
export function writeOldHdr(name) {
  const [first, other] = [[128, 64, 32, 129], [90, 80, 70, 127]].map((pixel) => Buffer.from(pixel));
  const head = Buffer.from('#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 300 +X 600\n');
  const repeated = (times) => Buffer.from([1, 1, 1, times]);
  const rows = Array.from({ length: 300 }, (_, row) => (row === 0 ? [first, repeated(87), repeated(2)] : [other, repeated(87), repeated(2)]));
  fs.writeFileSync(inFolder(name), Buffer.concat([head, ...rows.flat()]));
}

/** Writes the same as OpenEXR, in single precision. */
export function writeExr(name, width, rgbe) {
  const height = rgbe.length / 4 / width;
  const text = (value) => Buffer.from(`${value}\0`);
  const ints = (...values) => Buffer.from(Int32Array.from(values).buffer);
  const floats = (...values) => Buffer.from(Float32Array.from(values).buffer);
  const entry = (key, type, value) => Buffer.concat([text(key), text(type), ints(value.length), value]);
  const channels = Buffer.concat([...['B', 'G', 'R'].flatMap((channel) => [text(channel), ints(2, 0, 1, 1)]), Buffer.from([0])]);
  const box = ints(0, 0, width - 1, height - 1);
  const head = Buffer.concat([Buffer.from([0x76, 0x2f, 0x31, 1, 2, 0, 0, 0]), entry('channels', 'chlist', channels), entry('compression', 'compression', Buffer.from([0])),
    entry('dataWindow', 'box2i', box), entry('displayWindow', 'box2i', box), entry('lineOrder', 'lineOrder', Buffer.from([0])), entry('pixelAspectRatio', 'float', floats(1)),
    entry('screenWindowCenter', 'v2f', floats(0, 0)), entry('screenWindowWidth', 'float', floats(1)), Buffer.from([0])]);
  const rowBytes = 8 + 12 * width;
  const offsets = Buffer.from(BigInt64Array.from({ length: height }, (_, row) => BigInt(head.length + 8 * height + rowBytes * row)).buffer);
  const rows = Array.from({ length: height }, (_, row) => Buffer.concat([ints(row, 12 * width), ...[2, 1, 0].map((c) => floats(
    ...Array.from({ length: width }, (_column, k) => rgbe[4 * (row * width + k) + c] * 2 ** (rgbe[4 * (row * width + k) + 3] - 136))))]));
  fs.writeFileSync(inFolder(name), Buffer.concat([head, offsets, ...rows]));
  return name;
}

/** Writes an OpenEXR picture once more, by the OpenEXR library (exr_as.cpp); compression: its number. */
export function writeExrAs(from, name, compression, type, order) {
  execFileSync(`${kBin}/exr_as`, [inFolder(from), inFolder(name), String(compression), type, order]);
  return name;
}

/** `width` x width / 2 pixels of noise. */
export function rgbeNoise(width) {
  let seed = 1;
  const next = () => { seed = (Math.imul(seed, 1103515245) + 12345) >>> 0; return seed >>> 16; };
  return Buffer.from(Array.from({ length: (width * width) / 2 }, () => [next() & 255, next() & 255, next() & 255, 120 + (next() & 15)]).flat());
}
