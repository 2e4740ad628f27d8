// Radiance RGBE pictures (.hdr), checked as prt/image/radiance_reader.cpp does. [Greg Ward, "Real Pixels", Graphics Gems II
// (1991), p. 80; Radiance file formats, filefmts.pdf]
import { pictureOf, requirePictureSize } from './light_picture.js';
import { FileError } from './transfer_file.js';

class RadianceReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
    this.row = 0;
  }

  fail(what) { throw new FileError(`${what}; expected a complete Radiance .hdr picture`); }

  line() {
    const end = this.bytes.indexOf(10, this.at);
    if (end < 0) this.fail('is truncated in its header');
    const text = String.fromCharCode(...this.bytes.subarray(this.at, Math.min(end, this.at + 1000)));
    this.at = end + 1;
    return text.replace(/\r$/, '');
  }

  byte() {
    if (this.at >= this.bytes.length) this.fail(`is truncated in row ${this.row}`);
    return this.bytes[this.at++];
  }

  header() {
    if (!/^#\?(RADIANCE|RGBE)/.test(this.line())) this.fail('does not begin with #?RADIANCE');
    let isRgbe = false, exposure = 1;
    for (let line = this.line(); line !== ''; line = this.line()) {
      if (line.startsWith('FORMAT=')) isRgbe = line === 'FORMAT=32-bit_rle_rgbe' || this.fail(`has ${line}; expected FORMAT=32-bit_rle_rgbe`);
      if (!line.startsWith('EXPOSURE=')) continue;
      const factor = parseFloat(line.slice(9));
      if (!(factor > 0 && factor < Infinity)) this.fail(`has the exposure \`${line.slice(9)}\`, which is no positive number`);
      exposure *= factor;  // several multiply
    }
    if (!isRgbe) this.fail('has no line FORMAT=32-bit_rle_rgbe in its header');
    const line = this.line();
    const [, height, width] = (/^-Y +(\d{1,9}) +\+X +(\d{1,9})$/.exec(line) ?? this.fail(`has the size line \`${line}\`; expected \`-Y HEIGHT +X WIDTH\` (top row first)`)).map(Number);
    return { width, height, exposure };
  }

  // Runs of 129..255 = 128 + count, dumps of 1..128; channel after channel.
  encoded(out) {
    const width = out.length / 4;
    for (let channel = 0; channel < 4; ++channel) {
      for (let i = 0; i < width;) {
        const code = this.byte();
        const isRun = code > 128;
        const count = isRun ? code - 128 : code;
        if (count === 0 || count > width - i) this.fail(`has a wrong run length in row ${this.row}`);
        let value = isRun ? this.byte() : 0;
        for (let k = 0; k < count; ++k, ++i) {
          if (!isRun) value = this.byte();
          out[4 * i + channel] = value;
        }
      }
    }
  }

  // (1, 1, 1, n) repeats the pixel before n << 8 k times, k such pixels being just before.
  plain(out) {
    for (let i = 0, shift = 1; i < out.length;) {
      const pixel = [this.byte(), this.byte(), this.byte(), this.byte()];
      if (pixel[0] !== 1 || pixel[1] !== 1 || pixel[2] !== 1) {
        out.set(pixel, i);
        i += 4;
        shift = 1;
        continue;
      }
      const count = pixel[3] * shift;
      if (i === 0 || 4 * count > out.length - i) this.fail(`has a wrong repetition in row ${this.row}`);
      for (let k = 0; k < count; ++k, i += 4) out.copyWithin(i, i - 4, i);
      shift *= 256;
    }
  }

  scanline(out) {
    const width = out.length / 4;
    const [a, b, c, d] = this.bytes.subarray(this.at, this.at + 4);
    if (!(width >= 8 && width < 32768 && a === 2 && b === 2 && c < 128)) return this.plain(out);
    if (256 * c + d !== width) this.fail(`has a wrong length of row ${this.row}`);
    this.at += 4;
    return this.encoded(out);
  }
}

/** Bytes -> picture. Throws FileError. */
export function readRadiance(bytes) {
  const reader = new RadianceReader(bytes);
  const { width, height, exposure } = reader.header();
  requirePictureSize(width, height);
  const pixels = new Float32Array(3 * width * height), rgbe = new Uint8Array(4 * width);
  for (let i = 0; reader.row < height; ++reader.row) {
    reader.scanline(rgbe);
    for (let k = 0; k < rgbe.length; k += 4, i += 3) {
      const factor = rgbe[k + 3] === 0 ? 0 : 2 ** (rgbe[k + 3] - 136) / exposure;
      for (let c = 0; c < 3; ++c) pixels[i + c] = rgbe[k + c] * factor;
    }
  }
  return pictureOf(width, height, pixels);
}
