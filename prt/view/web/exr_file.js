// OpenEXR pictures (.exr) of scan lines: plain, or compressed by run lengths, zlib or wavelets (PIZ). [OpenEXR file layout;
// technical introduction, "Data compression"; PIZ: wavelets of Christian Rouet, Huffman codes of Industrial Light & Magic]
import { pictureOf, requirePictureSize } from './light_picture.js';
import { FileError } from './transfer_file.js';

const kCompressions = ['plain', 'run lengths', 'zlib of lines', 'zlib', 'PIZ', 'PXR24', 'B44', 'B44A', 'DWAA', 'DWAB'];
const kLines = [1, 1, 1, 16, 32];  // of a chunk
const kBytesOfType = [4, 2, 4];  // unsigned integer, half, single

function refuse(what) { throw new FileError(`${what}; expected a complete OpenEXR picture`); }

class ExrReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = 0;
  }

  // The place of the next bytes, and behind them.
  take(count) {
    const at = this.at;
    if (!(count >= 0 && count <= this.bytes.length - at)) refuse('is truncated');
    this.at += count;
    return at;
  }

  int() { return this.view.getInt32(this.take(4), true); }

  text() {
    const end = this.bytes.indexOf(0, this.at);
    if (end < 0) refuse('is truncated in its header');
    const text = String.fromCharCode(...this.bytes.subarray(this.at, Math.min(end, this.at + 255)));
    this.at = end + 1;
    return text;
  }

  channels() {
    const channels = [];
    for (let name = this.text(); name !== ''; name = this.text()) {
      const type = this.int();
      this.take(4);
      if (!kBytesOfType[type]) refuse(`has a channel of the unknown type ${type}`);
      const sampling = [this.int(), this.int()];
      channels.push({ name, type, isWhole: sampling.every((step) => step === 1) });
    }
    return channels;
  }

  header() {
    if (this.bytes.length < 8 || this.int() !== 20000630) refuse('does not begin as OpenEXR');
    if (this.int() & 0x1a00) throw new FileError('has tiles, several parts or deep pixels, which `prt project` reads; this page reads scan lines');
    const header = {};
    for (let name = this.text(); name !== ''; name = this.text()) {
      this.text();
      const size = this.int();
      const next = this.take(size) + size;
      this.at = next - size;
      if (name === 'channels') header.channels = this.channels();
      if (name === 'compression') header.compression = this.bytes[this.take(1)];
      if (name === 'dataWindow') header.window = [this.int(), this.int(), this.int(), this.int()];
      this.at = next;
    }
    if (!header.channels || !header.window || !kCompressions[header.compression]) refuse('has no channels, data window or compression');
    return header;
  }
}

// R, G, B of the unnamed layer, or of the only layer that has all three, or Y three times, as prt takes them.
function colorChannels(channels) {
  const names = channels.map(({ name }) => name);
  const has = (layer) => ['R', 'G', 'B'].every((color) => names.includes(layer + color));
  const layers = names.filter((name) => name.endsWith('.R')).map((name) => name.slice(0, -1)).filter(has);
  const isGrey = names.includes('Y') && !names.includes('RY') && !names.includes('BY');
  const layer = has('') ? '' : layers.length === 1 ? layers[0] : null;
  if (layer === null && !(layers.length === 0 && isGrey)) {
    throw new FileError(`has the channels ${names.join(', ')}; expected R, G, B in one layer, or Y alone`);
  }
  const chosen = layer === null ? ['Y', 'Y', 'Y'] : ['R', 'G', 'B'].map((color) => layer + color);
  const flaw = chosen.find((name) => !channels[names.indexOf(name)].isWhole);
  if (flaw) throw new FileError(`the channel ${flaw} is subsampled; expected a value for every pixel`);
  return chosen.map((name) => names.indexOf(name));
}

// A count below 0: as many bytes as they are; else the next byte, one time more than the count.
function withoutRuns(bytes, size) {
  const out = new Uint8Array(size);
  let end = 0;
  for (let at = 0; at < bytes.length;) {
    const count = (bytes[at++] << 24) >> 24;
    const length = count < 0 ? -count : count + 1;
    if (length > size - end || (count < 0 ? length : 1) > bytes.length - at) refuse('has wrong run lengths');
    if (count < 0) out.set(bytes.subarray(at, at + length), end);
    else out.fill(bytes[at], end, end + length);
    at += count < 0 ? length : 1;
    end += length;
  }
  if (end !== size) refuse('has too few run lengths');
  return out;
}

async function inflated(bytes, size) {
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    const out = new Uint8Array(await new Response(stream).arrayBuffer());
    if (out.length === size) return out;
  } catch {
    // damaged
  }
  return refuse('has a chunk that is no zlib stream of its size');
}

// Bytes were stored as differences, those of even places before those of odd ones.
function withoutDifferences(bytes) {
  for (let i = 1; i < bytes.length; ++i) bytes[i] += bytes[i - 1] - 128;
  const half = Math.ceil(bytes.length / 2);
  return bytes.map((_, i) => bytes[(i & 1 ? half : 0) + (i >> 1)]);
}

// Bits from the highest one of each byte on.
class BitReader {
  constructor(bytes, count) {
    this.bytes = bytes;
    this.count = this.left = count;  // bits
    this.at = 0;
    this.held = 0;  // the bytes that were read last
    this.kept = 0;  // bits of them
  }

  peek(count) {
    for (; this.kept <= 24; this.kept += 8) this.held = (this.held << 8) | (this.bytes[this.at++] ?? 0);
    return (this.held >>> (this.kept - count)) & ((1 << count) - 1);
  }

  skip(count) {
    this.kept -= count;
    this.left -= count;
    if (this.left < 0) refuse('has a chunk that ends too early');
  }

  bits(count) {
    const value = this.peek(count);
    this.skip(count);
    return value;
  }

  bytesTaken() { return Math.ceil((this.count - this.left) / 8); }
}

const kLongestCode = 58, kShortZeros = 59, kLongZeros = 63, kShort = 12;

// Symbols by the length of their codes; codes of a length are consecutive, from `first` on. `short`: by the next kShort bits,
// 64 times the symbol, and the length of its code; -1 for longer ones.
function huffmanCodes(reader, least, most) {
  const symbols = Array.from({ length: kLongestCode + 1 }, () => []);
  for (let symbol = least; symbol <= most;) {
    const length = reader.bits(6);
    if (length >= kShortZeros) symbol += length === kLongZeros ? reader.bits(8) + 6 : length - kShortZeros + 2;
    else symbols[length].push(symbol++);
  }
  const first = new Array(kLongestCode + 1).fill(0), short = new Int32Array(1 << kShort).fill(-1);
  for (let length = kLongestCode, next = 0; length > 0; --length) {
    first[length] = next;
    next = Math.floor((next + symbols[length].length) / 2);
    if (length > kShort) continue;
    const step = 1 << (kShort - length);
    symbols[length].forEach((symbol, k) => short.fill(64 * symbol + length, (first[length] + k) * step, (first[length] + k + 1) * step));
  }
  return { symbols, first, short };
}

function longSymbol(reader, { symbols, first }) {
  let code = reader.bits(kShort);
  for (let length = kShort + 1; length <= kLongestCode; ++length) {
    code = 2 * code + reader.bits(1);
    const symbol = symbols[length][code - first[length]];
    if (symbol !== undefined) return symbol;
  }
  return refuse('has a wrong code');
}

// The largest symbol repeats the number before, as often as 8 more bits say.
function huffmanDecoded(bytes, size) {
  if (bytes.length < 20) refuse('has a chunk that ends too early');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [least, most, , bits] = [0, 4, 8, 12].map((at) => view.getUint32(at, true));
  if (least > most || most > 65536) refuse('has a wrong table of codes');
  const table = new BitReader(bytes.subarray(20), 8 * (bytes.length - 20));
  const codes = huffmanCodes(table, least, most);
  const data = bytes.subarray(20 + table.bytesTaken());
  if (bits > 8 * data.length) refuse('has a chunk that ends too early');
  const reader = new BitReader(data, bits);
  const out = new Uint16Array(size);
  for (let end = 0; end < size;) {
    const entry = codes.short[reader.peek(kShort)];
    if (entry >= 0) reader.skip(entry & 63);
    const symbol = entry >= 0 ? entry >> 6 : longSymbol(reader, codes);
    if (symbol < most) {
      out[end++] = symbol;
      continue;
    }
    const count = reader.bits(8);
    if (end === 0 || count > size - end) refuse('has a wrong run length');
    out.fill(out[end - 1], end, end + count);
    end += count;
  }
  if (reader.left > 0) refuse('has a chunk with more codes than numbers');
  return out;
}

// A mean and a difference -> the two numbers; of numbers below 2^14, which have a sign, and of all, modulo 2^16.
const pairOfSmall = (mean, difference) => {
  const d = (difference << 16) >> 16;
  const a = ((mean << 16) >> 16) + (d & 1) + (d >> 1);
  return [a & 0xffff, (a - d) & 0xffff];
};
const pairOfAll = (mean, difference) => {
  const b = (mean - (difference >> 1)) & 0xffff;
  return [(difference + b - 0x8000) & 0xffff, b];
};

// Undoes the wavelets of nx times ny numbers: their steps in memory are stepX and stepY, from the coarse to the fine.
function undoWavelets(numbers, start, nx, stepX, ny, stepY, pairOf) {
  const undo = (i, k) => { [numbers[i], numbers[k]] = pairOf(numbers[i], numbers[k]); };
  let coarse = 1;
  while (2 * coarse <= Math.min(nx, ny)) coarse *= 2;
  for (let fine = coarse >> 1; fine >= 1; coarse = fine, fine >>= 1) {
    const dx = stepX * fine, dy = stepY * fine;
    let y = 0;
    for (; y <= ny - coarse; y += coarse) {
      let x = 0;
      for (; x <= nx - coarse; x += coarse) {
        const at = start + x * stepX + y * stepY;
        undo(at, at + dy);
        undo(at + dx, at + dx + dy);
        undo(at, at + dx);
        undo(at + dy, at + dx + dy);
      }
      if (nx & fine) undo(start + x * stepX + y * stepY, start + x * stepX + y * stepY + dy);
    }
    if (!(ny & fine)) continue;
    for (let x = 0; x <= nx - coarse; x += coarse) undo(start + x * stepX + y * stepY, start + x * stepX + y * stepY + dx);
  }
}

// Channels one after the other, as numbers of 16 bits among the values that occur -> bytes, line by line.
function withoutWavelets(bytes, size, { channels, width }, lines) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 8) refuse('has a chunk that ends too early');
  const [least, most] = [view.getUint16(0, true), view.getUint16(2, true)];
  const begin = least <= most ? 4 + most - least + 1 : 4;
  if (most >= 8192 || begin + 4 > bytes.length) refuse('has a wrong table of values');
  const values = [0];
  for (let i = Math.max(1, 8 * least); least <= most && i < 8 * (most + 1); ++i) {
    if (bytes[4 + (i >> 3) - least] & (1 << (i & 7))) values.push(i);
  }
  const length = view.getInt32(begin, true);
  if (length < 0 || length > bytes.length - begin - 4) refuse('has a chunk that ends too early');
  const numbers = huffmanDecoded(bytes.subarray(begin + 4, begin + 4 + length), size / 2);
  const pairOf = values.length - 1 < 1 << 14 ? pairOfSmall : pairOfAll;
  const out = new Uint16Array(size / 2);
  const row = size / 2 / lines;
  let start = 0, column = 0;
  for (const { type } of channels) {
    const words = kBytesOfType[type] / 2;
    for (let k = 0; k < words; ++k) undoWavelets(numbers, start + k, width, words, lines, width * words, pairOf);
    for (let y = 0; y < lines; ++y) {
      for (let i = 0; i < width * words; ++i) out[y * row + column + i] = values[numbers[start + y * width * words + i]];
    }
    start += lines * width * words;
    column += width * words;
  }
  return new Uint8Array(out.buffer);  // little-endian, as GPUs and browsers are
}

async function unpacked(bytes, size, header, lines) {
  if (bytes.length === size) return bytes;  // what compression does not shorten stays plain
  switch (header.compression) {
    case 1: return withoutDifferences(withoutRuns(bytes, size));
    case 2: case 3: return withoutDifferences(await inflated(bytes, size));
    case 4: return withoutWavelets(bytes, size, header, lines);
    default: return refuse('has a chunk of a wrong size');
  }
}

function halfAt(view, at) {
  const bits = view.getUint16(at, true), exponent = (bits >> 10) & 31, fraction = bits & 1023;
  const size = exponent === 31 ? (fraction ? NaN : Infinity) : exponent === 0 ? fraction * 2 ** -24 : (1024 + fraction) * 2 ** (exponent - 25);
  return bits & 0x8000 ? -size : size;
}

const kNumberAt = [(view, at) => view.getUint32(at, true), halfAt, (view, at) => view.getFloat32(at, true)];

/** Bytes -> promise of a picture. Rejects with a FileError. */
export async function readExr(bytes) {
  const reader = new ExrReader(bytes);
  const header = reader.header();
  const [left, top, right, bottom] = header.window;
  const width = right - left + 1, height = bottom - top + 1;
  requirePictureSize(width, height);
  const colors = colorChannels(header.channels);
  if (!header.channels.every((channel) => channel.isWhole)) throw new FileError('has subsampled channels, which `prt project` reads; this page does not');
  const most = kLines[header.compression];
  if (!most) throw new FileError(`is compressed by ${kCompressions[header.compression]}, which \`prt project\` reads; this page reads plain pictures, run lengths, zlib and PIZ`);
  const begins = [];  // of channels in a line, in bytes
  let row = 0;
  for (const { type } of header.channels) {
    begins.push(row);
    row += width * kBytesOfType[type];
  }
  const chunks = Math.ceil(height / most);
  const table = reader.take(8 * chunks);
  const pixels = new Float32Array(3 * width * height);
  for (let chunk = 0; chunk < chunks; ++chunk) {
    reader.at = Number(reader.view.getBigUint64(table + 8 * chunk, true));
    const y = reader.int() - top;
    if (!(y >= 0 && y < height)) refuse('has a chunk of lines outside the picture');
    const lines = Math.min(most, height - y);
    const length = reader.int();
    const begin = reader.take(length);
    const data = await unpacked(bytes.subarray(begin, begin + length), lines * row, { ...header, width }, lines);
    const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
    for (let c = 0; c < 3; ++c) {
      const { type } = header.channels[colors[c]];
      for (let line = 0; line < lines; ++line) {
        for (let x = 0; x < width; ++x) {
          pixels[3 * ((y + line) * width + x) + c] = kNumberAt[type](view, line * row + begins[colors[c]] + x * kBytesOfType[type]);
        }
      }
    }
  }
  return pictureOf(width, height, pixels);
}
