// Relights a transfer file on WebGL 2, from its numbers as they are stored. In: the bytes of the file, and the shaders that
// `prt view` wrote for it. Out: what a vertex shader needs (attributes, textures, uniforms), and a Relighter that runs it.
// Lights are {degree, values}: values (3, bands^2), red, green, blue; i = l(l+1)+m; W m^-2 sr^-1 times sqrt(sr).
import { readTransfer, FileError } from './transfer_file.js';
import { kernelsOf } from './kernels.js';

const kLitWidth = 2048;  // of rows under the light, as prt/shaders/clusters.glsl reads them
const kNormalized = 127;  // RGBA8_SNORM reads q / 127
const kFormats = { single: 'RGBA32F', half: 'RGBA16F', byte: 'RGBA8_SNORM' };

const bandsSquared = (degree) => (degree + 1) * (degree + 1);

/** A light without radiance. */
export function darkness(degree) { return { degree, values: new Float64Array(3 * bandsSquared(degree)) }; }

/** The light in another degree: without its higher bands, or with zeros there. */
export function inDegree(light, degree) {
  const out = darkness(degree);
  const from = bandsSquared(light.degree), to = bandsSquared(degree);
  for (let c = 0; c < 3; ++c) out.values.set(light.values.subarray(c * from, c * from + Math.min(from, to)), c * to);
  return out;
}

/** The light turned by the rotation r (9 numbers, row by row): (R f)(s) = f(R^-1 s). */
export function turned(kernels, light, r) {
  const out = darkness(light.degree);
  const n = bandsSquared(light.degree);
  for (let c = 0; c < 3; ++c) {
    kernels[`rotate_l${light.degree}`](r, light.values.subarray(c * n, (c + 1) * n), out.values.subarray(c * n, (c + 1) * n));
  }
  return out;
}

/** Numbers as a texture, four a texel; as wide as high or twice as wide, so that it fits where the GPU has room for so many. */
export function texture(name, format, numbers) {
  const texels = Math.ceil(numbers.length / 4);
  const width = 2 ** Math.ceil(Math.log2(Math.max(1, texels)) / 2);
  const height = Math.max(1, Math.ceil(texels / width));
  const padded = new numbers.constructor(4 * width * height);
  padded.set(numbers);
  return { name, format, width, height, array: padded };
}

// The tables of BRDFs in the bands of the transfer, and the number of each vertex: 4 t + n, its n parts stand in the tables
// t, t + 1, ... (prt/shaders/brdfs.glsl).
function tablesOf({ sections, brdfs, shape }) {
  const kViews = 65, kParts = 3, kEven = 66;
  const even = ((shape.degree + 1) * (shape.degree + 2)) / 2;
  const tables = [], numbers = [];
  brdfs.forEach((head, number) => {
    const parts = head.measured ? 3 : 2;
    numbers.push(4 * (tables.length / (kViews * even)) + parts);
    for (let part = 0; part < parts; ++part) {
      for (let view = 0; view < kViews; ++view) {
        const first = ((number * kViews + view) * kParts + part) * kEven;
        tables.push(...sections.brdfrow.subarray(first, first + even));
      }
    }
  });
  return { tables: Float32Array.from(tables), brdf: Float32Array.from(sections.brdf, (n) => (n ? numbers[n - 1] : 0)) };
}

function attributesOf({ sections, isGlossy, shape }, brdf) {
  const all = [
    ['position', 0, 3, sections.position], ['albedo', 1, 3, shape.holdsAlbedo ? null : sections.albedo],
    ['normal', 2, 3, isGlossy ? sections.normal : null], ['emitted', 3, 3, sections.emitted],
    ['specular', 4, 3, isGlossy ? sections.specular : null], ['exponent', 5, 1, isGlossy ? sections.exponent : null],
    ['cluster', 6, 1, sections.cluster], ['matrix_cluster', 7, 1, sections.icluster], ['brdf', 8, 1, brdf],
  ];
  return all.filter(([, , , array]) => array).map(([name, location, components, array]) => (
    { name, location, components, array: array instanceof Float32Array ? array : Float32Array.from(array) }));
}

function texturesOf({ sections, isGlossy, shape, indirect }, tables) {
  const out = [];
  if (sections.transfer) out.push(texture(isGlossy ? 'rows' : 'transfer', kFormats[shape.element], sections.transfer));
  if (sections.weight) out.push(texture('weights', 'RGBA8_SNORM', sections.weight));
  if (sections.indirect) out.push(texture('matrices', kFormats[indirect.element], sections.indirect));
  if (sections.iweight) out.push(texture('matrix_weights', 'RGBA8_SNORM', sections.iweight));
  if (tables) out.push(texture('tables', 'RGBA32F', tables));
  return out;
}

// What the shaders depend on, as `prt view` writes it.
function needsOf({ kind, degree, rows, storage = null, indirect = null, brdfs = [] }) {
  const withoutError = (json) => (json && Object.fromEntries(Object.entries(json).filter(([key]) => key !== 'error')));
  return { kind, degree, rows, storage: withoutError(storage), indirect: withoutError(indirect), brdfs: brdfs.length > 0 };
}

/**
 * The file, checked, with what its shaders read. `runtime` is what `prt view` wrote for this file or one like it.
 * Throws FileError with one line, without the file's name.
 */
export function load(bytes, runtime) {
  const transfer = readTransfer(bytes);
  const needs = JSON.stringify(needsOf(transfer.header));
  if (needs !== JSON.stringify(runtime.shaders.needs)) {
    throw new FileError(`the shaders relight files of ${JSON.stringify(runtime.shaders.needs)}, this is one of ${needs}: write them again with \`prt view\``);
  }
  return bakedOf(transfer, runtime);
}

/** A transfer with what its shaders read. */
export function bakedOf(transfer, runtime) {
  const brdfs = transfer.isGlossy && transfer.brdfs.length > 0 ? tablesOf(transfer) : {};
  return {
    transfer,
    runtime,
    kernels: kernelsOf(runtime.kernels),
    attributes: attributesOf(transfer, brdfs.brdf),
    textures: texturesOf(transfer, brdfs.tables),
  };
}

/** Throws if the light needs a coefficient that the file leaves out, as require_kept of prt/runtime/relight.hpp. */
export function requireKept({ shape, header }, light) {
  if (shape.kept.length === 0 || shape.meets !== 'dot') return;
  const n = bandsSquared(light.degree);
  const largest = light.values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const needed = light.values.findIndex((value, i) => Math.abs(value) > 1e-6 * largest && !shape.kept.includes(i % n));
  if (needed >= 0) {
    throw new FileError(`the transfer keeps ${shape.kept.length} of ${n} coefficients, those of its plan's lights (turned: ` +
      `${header.plan?.light_turns || 'any'}); this light also has number ${needed % n}: bake with --without symmetry`);
  }
}

/**
 * The uniforms of a light in the axes of the mesh, of any degree: {name: Float32Array}. `light` is vec3[], `samples` vec4[],
 * `row_scale` float[].
 */
export function uniformsOf(baked, light) {
  const { shape, isGlossy, sections } = baked.transfer;
  const seen = inDegree(light, shape.degree);
  requireKept(baked.transfer, seen);
  const n = bandsSquared(shape.degree);
  const kept = shape.kept.length && !isGlossy ? shape.kept : Array.from({ length: n }, (_, i) => i);
  const scale = isGlossy ? null : sections.scale;
  const perChannel = shape.storedChannels === 3 ? kept.length : 0;
  const values = new Float32Array(3 * kept.length);
  kept.forEach((i, k) => {
    for (let c = 0; c < 3; ++c) {
      values[3 * k + c] = seen.values[c * n + i] * (scale ? scale[c * perChannel + k] * kNormalized : 1);
    }
  });
  const uniforms = { light: values };
  if (shape.meets !== 'operator') return uniforms;
  const single = Float32Array.from(seen.values);
  const count = shape.degree === 0 ? 1 : 8 * shape.degree * shape.degree + 4;
  uniforms.samples = new Float32Array(4 * Math.ceil((3 * count) / 4));
  for (let c = 0; c < 3; ++c) {
    const prepare = baked.kernels[`transfer_prepare_l${shape.degree}`];
    prepare(single.subarray(c * n, (c + 1) * n), uniforms.samples.subarray(c * count, (c + 1) * count));
  }
  if (sections.scale) uniforms.row_scale = Float32Array.from(sections.scale, (value) => value * kNormalized);
  return uniforms;
}

/** A program of two shaders, whose outputs `captured` transform feedback captures one after the other. */
export function programOf(gl, vertex, fragment, captured = []) {
  const program = gl.createProgram();
  const shaders = [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]].map(([type, text]) => {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    return shader;
  });
  if (captured.length > 0) gl.transformFeedbackVaryings(program, captured, gl.INTERLEAVED_ATTRIBS);
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    const log = shaders.map((shader) => gl.getShaderInfoLog(shader)).concat(gl.getProgramInfoLog(program)).filter(Boolean);
    throw new Error(`a shader of this page does not run on this GPU: ${log.join(' ').replace(/\s+/g, ' ').slice(0, 400)}`);
  }
  shaders.forEach((shader) => gl.deleteShader(shader));
  return program;
}

function texelsOf(gl, format) {
  const type = { RGBA32F: gl.FLOAT, RGBA16F: gl.HALF_FLOAT, RGBA8_SNORM: gl.BYTE }[format];
  return [gl[format], gl.RGBA, type];
}

function upload(gl, { name, format, width, height, array }) {
  const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  if (height > most || width > most) {
    throw new FileError(`its numbers (${name}) need a texture of ${width} x ${height}, this GPU has at most ${most} x ${most}: ` +
      'bake fewer vertices, a lower degree, or clusters (`--compress 128 8`)');
  }
  const [internal, layout, type] = texelsOf(gl, format);
  const id = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, id);
  for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
  gl.texStorage2D(gl.TEXTURE_2D, 1, internal, width, height);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  if (array) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, layout, type, array);
  return { id, width, height, layout, type };
}

const kNothing = '#version 300 es\nvoid main() {}\n';  // a fragment shader where nothing is drawn

/** Runs the shaders of a loaded file: light in, radiance of every vertex out, in a buffer of vec3. */
export class Relighter {
  constructor(gl, baked) {
    this.gl = gl;
    this.baked = baked;
    this.textures = Object.fromEntries(baked.textures.map((one) => [one.name, upload(gl, one)]));
    this.arrays = gl.createVertexArray();
    gl.bindVertexArray(this.arrays);
    this.buffers = {};
    for (const { name, location, components, array } of baked.attributes) {
      this.buffers[name] = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[name]);
      gl.bufferData(gl.ARRAY_BUFFER, array, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, components, gl.FLOAT, false, 0, 0);
    }
    gl.bindVertexArray(null);
    this.nothing = gl.createVertexArray();
    const { lit, pixels } = baked.runtime.shaders;
    this.passes = lit.map((pass) => this.passOf(pass, 'lit', this.nothing));
    if (pixels?.texels) this.passes.push(this.passOf(pixels.texels, 'of_texel', this.arrays));
    this.program = programOf(gl, baked.runtime.shaders.relight, kNothing, ['radiance']);
    this.feedback = gl.createTransformFeedback();
    /** Linear RGB radiance of every vertex, 3 floats each. */
    this.radiance = this.bufferFor(12 * baked.transfer.vertices);
  }

  passOf({ shader, texture: name, rows, parts }, captured, arrays) {
    const gl = this.gl;
    const height = Math.max(1, Math.ceil((parts * rows) / kLitWidth));
    this.textures[name] = upload(gl, { name, format: 'RGBA32F', width: kLitWidth, height });
    const program = programOf(gl, shader, kNothing, [captured]);
    return { name, program, arrays, rows, parts, buffer: this.bufferFor(16 * kLitWidth * height) };
  }

  bufferFor(bytes) {
    const gl = this.gl;
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.DYNAMIC_COPY);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    return buffer;
  }

  /**
   * Relights every vertex. light: in the axes of the mesh. eye: in its coordinates, for glossy kinds. surface: null, or
   * {specular, exponent} for all vertices in place of those of the file. waits: the radiance is not computed before refresh().
   */
  relight(light, { eye = [0, 0, 0], surface = null, waits = false } = {}) {
    this.uniforms = { ...uniformsOf(this.baked, light), eye: Float32Array.from(eye) };
    for (const pass of this.passes) {
      this.use(pass.program, pass.arrays);
      this.capture(pass.buffer, pass.rows, pass.parts);
      this.copyToTexture(pass.buffer, this.textures[pass.name]);
    }
    this.surface = surface;
    this.isOld = true;
    if (!waits) this.refresh();
  }

  /** Computes the radiance if that has waited. */
  refresh() {
    if (!this.isOld) return;
    this.isOld = false;
    this.use(this.program, this.arrays);
    this.capture(this.radiance, this.baked.transfer.vertices, 1);
  }

  /** Writes other numbers into a texture of the file: as many as it has. */
  setNumbers(name, numbers) {
    const gl = this.gl;
    const { array, format, width, height } = this.baked.textures.find((one) => one.name === name);
    array.set(numbers);
    const [, layout, type] = texelsOf(gl, format);
    gl.bindTexture(gl.TEXTURE_2D, this.textures[name].id);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, layout, type, array);
  }

  // Attributes without an array have one value for all vertices, and for all that is drawn: it is set before each use.
  useAttributes() {
    const { gl, surface } = this;
    gl.bindVertexArray(this.arrays);
    for (const [name, location] of [['specular', 4], ['exponent', 5], ['brdf', 8]]) {
      const has = this.buffers[name] && !surface;
      has ? gl.enableVertexAttribArray(location) : gl.disableVertexAttribArray(location);
    }
    gl.vertexAttrib3fv(4, surface?.specular ?? [0, 0, 0]);
    gl.vertexAttrib1f(5, surface?.exponent ?? 0);
    gl.vertexAttrib1f(8, 0);
    for (const location of [3, 6, 7]) gl.vertexAttrib3f(location, 0, 0, 0);
  }

  /** Makes a program ready: the uniforms of the light, textures, attributes. */
  use(program, arrays) {
    const gl = this.gl;
    gl.useProgram(program);
    for (const [name, values] of Object.entries(this.uniforms)) {
      const set = { light: 'uniform3fv', samples: 'uniform4fv', row_scale: 'uniform1fv', eye: 'uniform3fv' }[name];
      gl[set](gl.getUniformLocation(program, name), values);
    }
    Object.entries(this.textures).forEach(([name, { id }], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, id);
      gl.uniform1i(gl.getUniformLocation(program, name), unit);
    });
    arrays === this.arrays ? this.useAttributes() : gl.bindVertexArray(arrays);
  }

  // Runs the program in use for `count` vertices, whose output goes into the buffer.
  capture(buffer, count, instances) {
    const gl = this.gl;
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, this.feedback);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.beginTransformFeedback(gl.POINTS);
    gl.drawArraysInstanced(gl.POINTS, 0, count, instances);
    gl.endTransformFeedback();
    gl.disable(gl.RASTERIZER_DISCARD);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, null);
    gl.bindVertexArray(null);
  }

  copyToTexture(buffer, { id, width, height, layout, type }) {
    const gl = this.gl;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, id);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, buffer);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, layout, type, 0);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
  }

  /** The radiance of vertices, (count, 3), of all without arguments: waits for the GPU. */
  read(first = 0, count = this.baked.transfer.vertices) {
    this.refresh();
    const out = new Float32Array(3 * count);
    const gl = this.gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.radiance);
    gl.getBufferSubData(gl.ARRAY_BUFFER, 12 * first, out);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    return out;
  }

  /** Frees what it has on the GPU. */
  dispose() {
    const gl = this.gl;
    for (const { id } of Object.values(this.textures)) gl.deleteTexture(id);
    for (const buffer of [...Object.values(this.buffers), ...this.passes.map((pass) => pass.buffer), this.radiance]) {
      gl.deleteBuffer(buffer);
    }
    for (const program of [this.program, ...this.passes.map((pass) => pass.program)]) gl.deleteProgram(program);
    for (const arrays of [this.arrays, this.nothing]) gl.deleteVertexArray(arrays);
    gl.deleteTransformFeedback(this.feedback);
  }
}
