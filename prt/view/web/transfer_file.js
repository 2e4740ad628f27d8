// Reads a transfer file (prt/FILES.md states it byte by byte) and checks it as prt/transfer/transfer_reader.cpp does: the
// same checks in the same order, the same words. Numbers stay as they are stored; shaders decode them.
import { checksum } from './checksum.js';

const kMagic = 'shprt\r\n\x1a';
const kOldestVersion = 1;
const kVersion = 2;
const kPrologueBytes = 48;
const kEntryBytes = 40;
const kMaxDegree = 10;
const kMostClusters = 4096;
const kMostVectors = 64;
const kSteps = 127;  // of a weight, from 0 to 1
const kNoVertex = 0xFFFFFFFF;
const kFloat = 0, kIndex = 1, kHalf = 2, kByte = 3, kSmall = 4;  // types of sections
const kArrays = [Float32Array, Uint32Array, Uint16Array, Int8Array, Uint16Array];
const kElements = ['single', 'half', 'byte'];
const kMeets = ['dot', 'operator', 'nothing'];
const kSamplers = ['fibonacci', 'stratified', 'sobol', 'random', 'cosine'];
const kTableNumbers = 65 * 3 * 66;  // of a BRDF

const count = (degree) => (degree + 1) * (degree + 1);

// Name, type, columns (0: as many as a row has, or weights), rows, and whether it may be left out.
const kSections = [
  ['position', kFloat, 3, 'vertices'], ['normal', kFloat, 3, 'vertices'], ['geonorm', kFloat, 3, 'vertices'],
  ['albedo', kFloat, 3, 'vertices'], ['face', kIndex, 3, 'other'], ['remap', kIndex, 1, 'other'],
  ['transfer', kFloat, 0, 'stored'], ['emitted', kFloat, 3, 'vertices', true], ['scale', kFloat, 0, 'one', true],
  ['mirror', kFloat, 3, 'vertices', true], ['specular', kFloat, 3, 'vertices', true],
  ['exponent', kFloat, 1, 'vertices', true], ['brdf', kSmall, 1, 'vertices', true], ['brdfrow', kFloat, 66, 'other', true],
  ['texture', kFloat, 2, 'vertices', true], ['normmap', kSmall, 1, 'vertices', true], ['normtex', kHalf, 3, 'other', true],
  ['albmap', kSmall, 1, 'vertices', true], ['tint', kFloat, 3, 'vertices', true], ['albpic', kByte, 1, 'other', true],
  ['chart', kFloat, 2, 'vertices', true], ['atlas', kSmall, 1, 'vertices', true], ['texel', kIndex, 1, 'other', true],
  ['indirect', kHalf, 0, 'stored'], ['cluster', kSmall, 1, 'vertices'], ['weight', kByte, 0, 'vertices'],
  ['icluster', kSmall, 1, 'vertices'], ['iweight', kByte, 0, 'vertices'], ['density', kFloat, 1, 'vertices'],
].map(([name, type, columns, rows, optional = false]) => ({
  name, type, columns, rows, optional,
  isWeight: name.endsWith('weight'),
  isOfClusters: name.endsWith('weight') || name.endsWith('cluster'),
  isOfIndirect: name.startsWith('i'),
  isOfMesh: !['transfer', 'emitted', 'scale', 'indirect', 'cluster', 'weight', 'icluster', 'iweight', 'density'].includes(name),
}));

const kDiffuse = { highest: kMaxDegree, meets: 'dot', result: () => 0, channels: 1, cosine: true, albedo: false };
const kGlossy = { highest: 5, meets: 'operator', result: (degree) => degree, channels: 1, cosine: false, albedo: false };
const kKinds = {
  DU: kDiffuse,
  DS: kDiffuse,
  DI: { ...kDiffuse, channels: 3, albedo: true, bounces: true },
  GU: { ...kGlossy, highest: kMaxDegree, meets: 'nothing' },
  GS: kGlossy,
  GI: { ...kGlossy, bounces: true, indirect: true },
  DT: { ...kDiffuse, channels: 3, albedo: true },
  N: { ...kGlossy, onGrid: true },  // the result of those on a grid may have any degree
  DV: { ...kDiffuse, channels: 3, albedo: true, onGrid: true, inMedium: true },
};

/** What is wrong with a file, as one line; the name of the file is left to who catches it. */
export class FileError extends Error {}

function fail(line) { throw new FileError(line); }

// The shape of the numbers of a vertex, as prt/transfer/shape.hpp has it.
function shapeOf(channels, degree, resultDegree, meets, storage = {}) {
  const columns = meets === 'nothing' ? 0 : count(meets === 'operator' ? degree + resultDegree : degree);
  const rows = meets === 'dot' ? count(resultDegree) : 1;
  const shape = { channels, degree, resultDegree, meets, rows, columns, element: 'single', oneChannel: false, kept: [],
                  clusters: 0, vectors: 0, ...storage };
  shape.count = rows * columns;
  shape.storedChannels = shape.oneChannel ? 1 : channels;
  shape.storedLength = shape.storedChannels * rows * (shape.kept.length || columns);
  return shape;
}

function typeOf(value) { return Array.isArray(value) ? 'array' : value === null ? 'null' : typeof value; }

// The entry of a header, of one of these types.
function entry(json, name, ...types) {
  if (typeOf(json) !== 'object' || !(name in json) || !types.includes(typeOf(json[name]))) {
    fail('its JSON header lacks an entry or has one of the wrong type');
  }
  return json[name];
}

function whole(value, least = 0, most = Number.MAX_SAFE_INTEGER) {
  if (!Number.isSafeInteger(value) || value < least || value > most) {
    fail(`transfer file whose JSON header has ${JSON.stringify(value)}, expected a whole number from ${least} to ${most}`);
  }
  return value;
}

function amount(json, name) {
  const value = entry(json, name, 'number');
  if (!(value >= 0)) fail(`transfer file whose JSON header has ${value}, expected a number of 0 or more`);
  return value;
}

// The nodes of the model files, each with its runs of faces.
function nodesOf(header) {
  const faces = whole(entry(header, 'faces', 'number'));
  return entry(header, 'nodes', 'array').map((node) => {
    const toWorld = entry(node, 'to_world', 'array');
    if (toWorld.length !== 12 || !toWorld.every(Number.isFinite)) {
      fail('transfer file with a node whose `to_world` is not 3 x 4 numbers');
    }
    let end = 0;
    for (const run of entry(node, 'faces', 'array')) {
      const [first, count] = [whole(entry({ run }, 'run', 'array')[0]), whole(run[1], 1)];
      if (run.length !== 2 || first < end || first + count > faces) {
        fail('transfer file with a node whose runs of faces do not rise, or name missing faces');
      }
      end = first + count;
    }
    return { name: entry(node, 'name', 'string'), material: entry(node, 'material', 'string'), toWorld, faces: node.faces };
  });
}

function clustersOf(json) {
  if (!('clusters' in json)) return {};
  return { clusters: whole(json.clusters, 1, kMostClusters), vectors: whole(entry(json, 'vectors', 'number'), 0, kMostVectors) };
}

function storageOf(json, columns) {
  const element = entry(json, 'element', 'string');
  const oneChannel = entry(json, 'one_channel', 'boolean');
  const kept = entry(json, 'kept', 'array').map((column) => whole(column, 0, 0xFFFFFFFF));
  const rises = kept.every((column, k) => column < columns && (k === 0 || kept[k - 1] < column));
  if (!kElements.includes(element) || !rises || columns === 0) {
    fail('transfer file whose JSON header names a storage that does not exist');
  }
  return { element, oneChannel, kept, ...clustersOf(json) };
}

function shapeOfHeader(header, version, letters) {
  const kind = kKinds[letters];
  const named = entry(header, 'degree', 'number', 'string');
  if (typeof named === 'number' && !(named >= 0 && named <= kind.highest)) {
    fail(`transfer of degree ${named}, expected 0 to ${kind.highest}`);
  }
  const degree = whole(named, 0, kind.highest);
  let expected = shapeOf(kind.channels, degree, kind.result(degree), kind.meets);
  let channels = 1, resultDegree = expected.resultDegree, meets = expected.meets, cosine = kind.cosine, albedo = kind.albedo;
  if (version === 1) {
    channels = 'channels' in header ? whole(header.channels) : 1;
  } else {
    channels = whole(entry(header, 'channels', 'number'));
    resultDegree = whole(entry(header, 'result_degree', 'number'), 0, kMaxDegree);
    if (kind.onGrid) expected = shapeOf(kind.channels, degree, resultDegree, kind.meets);
    meets = entry(header, 'meets', 'string');
    if (!kMeets.includes(meets)) fail(`transfer that meets the light by ${meets}, expected one of ${kMeets.join(', ')}`);
    cosine = entry(header, 'holds_cosine', 'boolean');
    albedo = entry(header, 'holds_albedo', 'boolean');
  }
  const rows = whole(entry(header, 'rows', 'number'));
  const columns = version === 1 ? expected.columns : whole(entry(header, 'columns', 'number'));
  if (channels !== expected.channels || resultDegree !== expected.resultDegree || meets !== expected.meets ||
      cosine !== kind.cosine || albedo !== kind.albedo || rows !== expected.rows || columns !== expected.columns) {
    fail(`transfer of kind ${letters} and degree ${degree} with ${channels} channels of ${rows} x ${columns} numbers, ` +
         `expected ${expected.channels} of ${expected.rows} x ${expected.columns}`);
  }
  const storage = 'storage' in header ? storageOf(header.storage, columns) : {};
  return { ...shapeOf(channels, degree, resultDegree, meets, storage), holdsCosine: cosine, holdsAlbedo: albedo };
}

function indirectOf(json, degree) {
  const channels = whole(entry(json, 'channels', 'number'), 1, 3);
  const degreeOf = (name) => {
    const root = Math.sqrt(entry(json, name, 'number'));
    return Number.isInteger(root) && root <= degree + 1 ? root - 1 : -1;
  };
  const resultDegree = degreeOf('rows');
  const lightDegree = degreeOf('columns');
  const element = entry(json, 'element', 'string');
  if (channels === 2 || resultDegree < 0 || lightDegree < 0 || element !== 'half') {
    fail(`transfer file with indirect matrices of ${json.channels} x ${json.rows} x ${json.columns} "${element}", ` +
         `expected 1 or 3 x squares of 1 to ${degree + 1} half`);
  }
  return shapeOf(channels, lightDegree, resultDegree, 'dot', { element, ...clustersOf(json) });
}

function checkBounces(json) {
  entry(json, 'solver', 'string');
  whole(entry(json, 'applications', 'number'));
  const certified = entry(json, 'certified', 'boolean');
  for (const name of ['residual', 'largest', 'spectral_bound']) amount(json, name);
  if (certified) amount(json, 'bound');
  entry(json, 'bound', 'number', 'null');
}

function frameOf(json) {
  const origin = entry(json, 'origin', 'array');
  const unit = entry(json, 'unit', 'number');
  if (origin.length !== 3 || !origin.every((x) => Math.abs(x) <= 1e100) || !(unit >= 0.5e-30 && unit <= 2e30)) {
    fail('transfer file whose frame has an origin or a unit that is no length');
  }
  return { origin, unit };
}

function gridOf(json) {
  const box = entry(json, 'box', 'array'), counts = entry(json, 'counts', 'array');
  if (box.length !== 2 || box.some((corner) => corner.length !== 3) || counts.length !== 3) {
    fail('transfer file whose grid has more than three axes');
  }
  counts.forEach((n) => whole(n, 0, 0xFFFFFFFF));
  const filled = whole(entry(json, 'filled', 'number'));
  const [low, high] = box;
  if (!box.flat().every((x) => Math.abs(x) <= 1e30) || !low.every((x, axis) => high[axis] - x > 0)) {
    fail(`transfer file: the box of its grid is from ${low.join(' ')} to ${high.join(' ')}, expected three sides above 0`);
  }
  const points = counts[0] * counts[1] * counts[2];
  if (!counts.every((n) => n >= 2 && n <= 4096) || points > 2 ** 27) {
    fail(`transfer file: its grid has ${counts.join(' x ')} points, expected 2 to 4096 along an axis and at most ${2 ** 27} in all`);
  }
  if (filled > points) fail(`transfer file: ${filled} points of its grid are filled, expected at most ${points}`);
  return { box, counts, points };
}

function checkMedium(json) {
  const albedo = entry(json, 'albedo', 'array'), anisotropy = entry(json, 'anisotropy', 'number');
  whole(entry(json, 'directions', 'number'));
  if (albedo.length !== 3 || !albedo.every((value) => value >= 0 && value <= 1) || !(Math.abs(anisotropy) < 1)) {
    fail('transfer file of a medium whose albedo is not from 0 to 1, or anisotropy not within 1');
  }
  checkBounces(entry(json, 'scattering', 'object'));
}

class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  size(at) { return Number(this.data.getBigUint64(at, true)); }

  part(offset, length) {
    if (offset + length > this.bytes.length) fail('truncated transfer file');
    return this.bytes.subarray(offset, offset + length);
  }

  read() {
    this.readPrologue();
    this.readTable();
    const transfer = this.takeHeader(this.readHeader());
    this.transfer = transfer;
    this.checkShape();
    this.readSections();
    this.checkCounts();
    const flaw = flawOfValues(transfer);
    if (flaw) fail(`damaged transfer file: ${flaw}`);
    return transfer;
  }

  readPrologue() {
    const n = this.bytes.length;
    if (n < kPrologueBytes) fail(`not a transfer file: ${n} bytes, expected at least ${kPrologueBytes}`);
    if (String.fromCharCode(...this.bytes.subarray(0, 8)) !== kMagic) {
      fail('not a transfer file: it does not begin with `shprt`');
    }
    this.version = this.data.getUint32(8, true);
    if (this.version < kOldestVersion || this.version > kVersion) {
      fail(`transfer file of version ${this.version}, expected ${kOldestVersion} to ${kVersion}`);
    }
    if (this.size(16) !== n) fail(`truncated or overlong transfer file: ${n} bytes, expected ${this.size(16)}`);
    this.entries = this.data.getUint32(12, true);
    if (this.entries > kSections.length) {
      fail(`transfer file of ${this.entries} sections, expected at most ${kSections.length}`);
    }
  }

  readTable() {
    const table = this.part(kPrologueBytes, this.entries * kEntryBytes);
    const front = new Uint8Array(40 + table.length);
    front.set(this.bytes.subarray(0, 40));
    front.set(table, 40);
    if (checksum(front) !== this.data.getBigUint64(40, true)) {
      fail('damaged transfer file: the checksum of its section table differs');
    }
    this.table = [];
    for (let at = kPrologueBytes; at < kPrologueBytes + table.length; at += kEntryBytes) {
      this.table.push({
        name: String.fromCharCode(...this.bytes.subarray(at, at + 8)).replace(/\0+$/, ''),
        type: this.data.getUint32(at + 8, true), columns: this.data.getUint32(at + 12, true), rows: this.size(at + 16),
        offset: this.size(at + 24), checksum: this.data.getBigUint64(at + 32, true),
      });
    }
  }

  readHeader() {
    const size = this.size(24);
    if (size > this.bytes.length) fail('damaged transfer file: its JSON header is longer than the file');
    const header = this.part(kPrologueBytes + this.table.length * kEntryBytes, size);
    if (checksum(header) !== this.data.getBigUint64(32, true)) {
      fail('damaged transfer file: the checksum of its JSON header differs');
    }
    try {
      return JSON.parse(new TextDecoder().decode(header));
    } catch (error) {
      return fail(`its JSON header is not JSON: ${error.message}`);
    }
  }

  takeHeader(header) {
    const scene = entry(header, 'scene', 'string');
    const letters = entry(header, 'kind', 'string');
    if (!Object.hasOwn(kKinds, letters)) {
      fail(`transfer of kind ${letters}, expected one of ${Object.keys(kKinds).join(', ')}`);
    }
    const kind = kKinds[letters];
    const shape = shapeOfHeader(header, this.version, letters);
    const grid = kind.onGrid ? gridOf(entry(header, 'grid', 'object')) : null;
    const frame = 'frame' in header ? frameOf(header.frame) : { origin: [0, 0, 0], unit: 1 };
    if (kind.inMedium) checkMedium(entry(header, 'medium', 'object'));
    if (kind.bounces) checkBounces(entry(header, 'bounces', 'object'));
    const indirect = kind.indirect ? indirectOf(entry(header, 'indirect', 'object'), shape.degree) : null;
    if (shape.clusters) amount(header.storage, 'error');
    if (indirect?.clusters) amount(header.indirect, 'error');
    whole(entry(header, 'directions', 'number'));
    if ('sampler' in header && !kSamplers.includes(header.sampler)) {
      fail(`sampler ${header.sampler}, expected one of ${kSamplers.join(', ')}`);
    }
    entry(header, 'instruction_set', 'string');
    return { header, scene, kind: letters, isGlossy: !kind.cosine, shape, indirect, frame, grid, sections: {},
             brdfs: header.brdfs ?? [], normalMaps: header.normal_maps ?? [],
             albedoMaps: header.albedo_maps ?? [], atlases: header.atlases ?? [],
             nodes: 'nodes' in header ? nodesOf(header) : [] };
  }

  shapeFor(section) { return section.isOfIndirect ? this.transfer.indirect : this.transfer.shape; }

  columnsOf(section) {
    if (section.columns) return section.columns;
    const shape = this.shapeFor(section);
    return section.isWeight ? shape.vectors : shape.storedLength;
  }

  // always, optional or never
  presenceOf(section) {
    if (section.name === 'density' ? !kKinds[this.transfer.kind].inMedium : section.isOfMesh && this.transfer.grid) return 'never';
    if (section.isOfIndirect && !this.transfer.indirect) return 'never';
    if (section.isOfClusters && !this.shapeFor(section).clusters) return 'never';
    if (this.columnsOf(section) === 0) return 'never';
    return section.optional ? 'optional' : 'always';
  }

  // Those of the grid, or the vertices, which the first section has.
  get receivers() { return this.transfer.grid?.points ?? this.table[0].rows; }

  rowsOf(section, otherwise) {
    const shape = this.shapeFor(section);
    if (section.rows === 'stored' && shape.clusters) return shape.clusters * (1 + shape.vectors);
    return { vertices: this.receivers, stored: this.receivers, one: 1, other: otherwise }[section.rows];
  }

  checkShape() {
    let offset = kPrologueBytes + this.table.length * kEntryBytes + this.size(24);
    let next = 0;
    for (const found of this.table) {
      const at = kSections.findIndex((section, k) => k >= next && section.name === found.name);
      if (at < 0) {
        fail(`transfer file with a section \`${found.name.replace(/[^!-~]/g, '')}\`, which is unknown or out of place`);
      }
      this.checkLeftOut(next, at);
      this.checkSection(kSections[at], found, offset);
      offset += found.rows * found.columns * kArrays[found.type].BYTES_PER_ELEMENT;
      next = at + 1;
    }
    this.checkLeftOut(next, kSections.length);
    if (offset !== this.bytes.length) fail('damaged transfer file: bytes after its last section');
  }

  checkLeftOut(first, last) {
    const missing = kSections.slice(first, last).find((section) => this.presenceOf(section) === 'always');
    if (missing) fail(`damaged transfer file: section ${missing.name} is missing`);
  }

  checkSection(section, found, offset) {
    if (this.presenceOf(section) === 'never') {
      fail(`transfer file of kind ${this.transfer.kind} with a section ${section.name}, which it does not have`);
    }
    const element = kElements.indexOf(this.transfer.shape.element);
    const type = section.name === 'transfer' ? [kFloat, kHalf, kByte][element] : section.type;
    const columns = this.columnsOf(section);
    if (found.type !== type || found.columns !== columns || found.offset !== offset ||
        found.rows > (this.bytes.length - offset) / (columns * kArrays[type].BYTES_PER_ELEMENT) ||
        found.rows !== this.rowsOf(section, found.rows)) {
      fail(`damaged transfer file: section ${section.name} does not fit`);
    }
  }

  readSections() {
    for (const found of this.table) {
      const Items = kArrays[found.type];
      const bytes = this.part(found.offset, found.rows * found.columns * Items.BYTES_PER_ELEMENT);
      if (checksum(bytes) !== found.checksum) {
        fail(`damaged transfer file: the checksum of section ${found.name} differs`);
      }
      this.transfer.sections[found.name] = new Items(bytes.slice().buffer);
    }
    const { scale = [] } = this.transfer.sections;
    if ((scale.length === 0) === (this.transfer.shape.element === 'byte')) {
      fail('damaged transfer file: a scale belongs to 8-bit coefficients and to no others');
    }
    if (!scale.every((value) => value >= 0 && Number.isFinite(value))) {
      fail('damaged transfer file: a scale is negative or not finite');
    }
    this.transfer.vertices = this.receivers;
    this.transfer.faces = (this.transfer.sections.face ?? []).length / 3;
  }

  checkCounts() {
    const { header, vertices, faces, sections, grid } = this.transfer;
    if (grid) return;
    for (const [name, n] of [['vertices', vertices], ['faces', faces], ['file_vertices', sections.remap.length]]) {
      if (header[name] !== n) {
        fail(`damaged transfer file: its JSON header says that \`${name}\` is ${JSON.stringify(header[name])}, its sections ${n}`);
      }
    }
  }
}

const isFiniteHalf = (bits) => (bits & 0x7C00) !== 0x7C00;

function everyVector(values, test) {
  for (let i = 0; i < values.length; i += 3) if (!test(values[i], values[i + 1], values[i + 2])) return false;
  return true;
}

// What no bake writes; empty if there is nothing. As prt/transfer/transfer_values.cpp.
function flawOfValues({ sections, vertices, shape, indirect, brdfs, normalMaps, albedoMaps, atlases }) {
  const finite = (values) => values.every(Number.isFinite);
  const isUnit = (x, y, z) => Math.abs(Math.hypot(x, y, z) - 1) <= 1e-3;
  const isPart = (x) => x >= 0 && x <= 1;
  const { position = [], normal = [], geonorm = [], albedo = [], face = [], remap = [], density = [], emitted = [], mirror = [], specular = [], exponent = [], brdf = [],
          brdfrow = [], texture = [], normmap = [], normtex = [], cluster, weight, icluster, iweight } = sections;
  if (!density.every((value) => value >= 0 && Number.isFinite(value))) return 'a density is negative or not finite';
  if (!face.every((v) => v < vertices) || !remap.every((v) => v === kNoVertex || v < vertices)) {
    return 'it names a vertex that is not there';
  }
  if (!finite(position)) return 'a position is not finite';
  if (!everyVector(normal, isUnit) || !everyVector(geonorm, isUnit)) return 'a normal is not of length 1';
  if (!albedo.every(isPart)) return 'an albedo is not from 0 to 1';
  if (!mirror.every(isPart)) return "a mirror's reflectance is not from 0 to 1";
  if (!specular.every(isPart)) return 'a specular reflectance is not from 0 to 1';
  if (exponent.length * 3 !== specular.length || !exponent.every((e) => e >= 0 && e <= 1e6)) {
    return 'an exponent is not from 0 to 1e6';
  }
  if (brdfrow.length !== brdfs.length * kTableNumbers || (brdf.length === 0) !== (brdfs.length === 0) ||
      !brdf.every((number) => number <= brdfs.length)) {
    return 'it names a BRDF that is not there';
  }
  if (!brdfrow.every((value) => Math.abs(value) <= 1000)) return 'a coefficient of a BRDF is not from -1000 to 1000';
  const texels = normalMaps.reduce((sum, map) => sum + map.width * map.height, 0);
  if (normtex.length !== 3 * texels || (normmap.length === 0) !== (normalMaps.length === 0) ||
      texture.length !== 2 * Math.max(normmap.length, sections.albmap?.length ?? 0) || !normmap.every((number) => number <= normalMaps.length)) {
    return 'it names a normal map that is not there';
  }
  if (!finite(texture)) return 'a texture coordinate is not finite';
  const flaw = flawOfPictures(sections, albedoMaps, isPart) || flawOfAtlases(sections, atlases, vertices);
  if (flaw) return flaw;
  if (!normtex.every((bits) => (bits & 0x7FFF) <= 0x3C00)) return 'a texel of a normal map is not from -1 to 1';
  const isFinite = (numbers = []) => numbers.every(numbers instanceof Uint16Array ? isFiniteHalf : Number.isFinite);
  if (!isFinite(sections.transfer) || !isFinite(sections.indirect) || !finite(emitted)) {
    return 'a transfer coefficient is not finite';
  }
  return flawOfClusters(shape, cluster, weight) || (indirect ? flawOfClusters(indirect, icluster, iweight) : '');
}

function flawOfPictures({ albmap = [], tint = [], albpic = [] }, pictures, isPart) {
  const bytes = pictures.reduce((sum, picture) => sum + picture.bytes, 0);
  if (albpic.length !== bytes || (albmap.length === 0) !== (pictures.length === 0) || tint.length !== 3 * albmap.length ||
      !albmap.every((number) => number <= pictures.length)) {
    return 'it names a picture of the albedo that is not there';
  }
  return tint.every(isPart) ? '' : 'a tint is not from 0 to 1';
}

// Texels are vertices, and rise in their atlas.
function flawOfAtlases({ chart = [], atlas = [], texel = [] }, atlases, vertices) {
  let entry = 0;
  for (const { width, height, first, texels } of atlases) {
    if (first + texels > vertices || entry + texels > texel.length) return 'an atlas names texels that are not there';
    const own = texel.slice(entry, entry + texels);
    if (!own.every((pixel, i) => pixel < width * height && (i === 0 || pixel > own[i - 1]))) {
      return 'the texels of an atlas are not in order, or beyond its size';
    }
    entry += texels;
  }
  if (entry !== texel.length || chart.length !== 2 * atlas.length || (atlas.length === 0) !== (atlases.length === 0) ||
      !atlas.every((number) => number <= atlases.length && (number === 0 || atlases[number - 1].texels > 0))) {
    return 'it names an atlas that is not there';
  }
  return chart.every((x) => x >= -1e-4 && x <= 1 + 1e-4) ? '' : 'a place in an atlas is not from 0 to 1';
}

function flawOfClusters(shape, cluster = [], weight = []) {
  if (!cluster.every((number) => number < shape.clusters)) return 'it names a cluster that is not there';
  return weight.every((number) => number >= -kSteps) ? '' : 'a weight is below -127';
}

/** Float of an IEEE binary16. */
export function floatOfHalf(bits) {
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 1023;
  const size = exponent === 0 ? fraction * 2 ** -24 : (1024 + fraction) * 2 ** (exponent - 25);
  return bits & 0x8000 ? -size : size;
}

// Adds factor times stored row `row` of a section to `out`, channel by channel, in complete columns.
function addRow(shape, stored, scale, row, factor, out) {
  const kept = shape.kept.length || shape.columns;
  for (let c = 0; c < shape.channels; ++c) {
    for (let k = 0; k < shape.rows * kept; ++k) {
      const column = (shape.oneChannel ? 0 : c) * shape.rows * kept + k;
      const number = stored[row * shape.storedLength + column];
      const value = shape.element === 'half' ? floatOfHalf(number) : scale ? number * scale[column] : number;
      const place = shape.kept.length ? Math.floor(k / kept) * shape.columns + shape.kept[k % kept] : k;
      out[c * shape.count + place] += factor * value;
    }
  }
}

/** The node that a vertex belongs to, or undefined: of its first face. */
export function nodeOf({ nodes, sections: { face } }, vertex) {
  const of = Math.floor(face.indexOf(vertex) / 3);
  return nodes.find(({ faces }) => faces.some(([first, count]) => first <= of && of < first + count));
}

/** The numbers of a vertex, (channels, rows, columns), decoded: for inspection, not for relighting. */
export function numbersOf(transfer, vertex) {
  const { shape, sections } = transfer;
  const out = new Float64Array(shape.channels * shape.count);
  if (shape.count === 0) return out;
  if (!shape.clusters) {
    addRow(shape, sections.transfer, sections.scale, vertex, 1, out);
    return out;
  }
  const mean = sections.cluster[vertex] * (1 + shape.vectors);
  addRow(shape, sections.transfer, sections.scale, mean, 1, out);
  for (let k = 0; k < shape.vectors; ++k) {
    const weight = sections.weight[vertex * shape.vectors + k] / kSteps;
    addRow(shape, sections.transfer, sections.scale, mean + 1 + k, weight, out);
  }
  return out;
}

/** bytes (Uint8Array) -> the transfer. Throws FileError, one line without the file's name. */
export function readTransfer(bytes) { return new Reader(bytes).read(); }
