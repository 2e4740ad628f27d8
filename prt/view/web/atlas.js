// Atlases on the GPU: the receivers of their pixels, as prt/shaders/atlas.glsl reads them.
import { FileError } from './transfer_file.js';

export const kWide = 4096;  // of textures that hold one thing after another
const kMostAtlases = 32;

// The vertex that each pixel of an atlas stands for: its texel, or the one that is nearest ring by ring.
function verticesOf({ width, height, first }, texels) {
  const vertices = new Uint32Array(width * height).fill(0xFFFFFFFF);
  let edge = [];
  texels.forEach((pixel, i) => {
    vertices[pixel] = first + i;
    edge.push(pixel);
  });
  while (edge.length > 0) {
    const next = [];
    for (const pixel of edge) {
      const column = pixel % width, row = (pixel - column) / width;
      for (let y = Math.max(row - 1, 0); y <= Math.min(row + 1, height - 1); ++y) {
        for (let x = Math.max(column - 1, 0); x <= Math.min(column + 1, width - 1); ++x) {
          if (vertices[y * width + x] !== 0xFFFFFFFF) continue;
          vertices[y * width + x] = vertices[pixel];
          next.push(y * width + x);
        }
      }
    }
    edge = next;
  }
  return vertices;
}

/** A texture, kWide texels a row, of as many numbers as there are, `components` a texel. */
export function wideTexture(gl, numbers, { internal, layout, type, components }) {
  const rows = Math.max(1, Math.ceil(numbers.length / components / kWide));
  const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
  if (rows > most || kWide > most) {
    throw new FileError(`its receivers need a texture of ${kWide} x ${rows}, this GPU has at most ${most} x ${most}: bake fewer texels`);
  }
  const padded = new numbers.constructor(rows * kWide * components);
  padded.set(numbers);
  const id = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, id);
  for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  gl.texImage2D(gl.TEXTURE_2D, 0, internal, kWide, rows, 0, layout, type, padded);
  return id;
}

/** (vertices, 3): u, v, and the number of the atlas + 1, or 0. */
export function placesInAtlases({ sections: { chart = [], atlas = [] }, vertices }) {
  const places = new Float32Array(3 * vertices);
  atlas.forEach((number, v) => places.set([chart[2 * v], chart[2 * v + 1], number], 3 * v));
  return places;
}

export class AtlasTexels {
  constructor(gl, { atlases, sections: { texel = new Uint32Array(0) } }) {
    if (atlases.length > kMostAtlases) throw new FileError(`${atlases.length} atlases: a page shows at most ${kMostAtlases} in a file`);
    this.gl = gl;
    this.atlases = new Int32Array(3 * kMostAtlases);  // first pixel, width, height
    const all = [];
    let entry = 0, first = 0;
    atlases.forEach((head, number) => {
      all.push(verticesOf(head, texel.subarray(entry, entry += head.texels)));
      this.atlases.set([first, head.width, head.height], 3 * number);
      first += head.width * head.height;
    });
    const receivers = new Uint32Array(first);
    all.forEach((vertices, number) => receivers.set(vertices, this.atlases[3 * number]));
    this.id = wideTexture(gl, receivers, { internal: gl.R32UI, layout: gl.RED_INTEGER, type: gl.UNSIGNED_INT, components: 1 });
  }

  /** Hands them to the program in use, in this unit. */
  use(program, unit) {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, this.id);
    gl.uniform1i(gl.getUniformLocation(program, 'receivers'), unit);
    gl.uniform3iv(gl.getUniformLocation(program, 'atlases'), this.atlases);
  }
}
