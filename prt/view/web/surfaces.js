// Diffuse surfaces pixel by pixel: light between the texels of an atlas, and the picture of the albedo over it, as
// prt/rays/receivers_at.hpp and prt/runtime/surface_colors.hpp have it.
import { FileError } from './transfer_file.js';
import { programOf } from './relight.js';

const kWide = 4096;  // of textures that hold one thing after another, as surfaces.frag reads them
const kMostAtlases = 32;

/** A file of the page with its pictures decoded: baked.pictures. Throws FileError. */
export async function withPictures(file) {
  const { albedoMaps, sections } = file.baked.transfer;
  file.baked.pictures = [];
  let first = 0;
  for (const { name, bytes } of albedoMaps) {
    const data = new Blob([sections.albpic.slice(first, first += bytes)]);
    file.baked.pictures.push(await createImageBitmap(data, { colorSpaceConversion: 'none', premultiplyAlpha: 'none' })
      .catch(() => { throw new FileError(`${file.name}: picture ${name}: this browser cannot read it; expected PNG or JPEG`); }));
  }
  return file;
}

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

const inRows = (numbers, components) => {
  const rows = Math.max(1, Math.ceil(numbers.length / components / kWide));
  const padded = new numbers.constructor(rows * kWide * components);
  padded.set(numbers);
  return { rows, padded };
};

/** What a DrawnMesh of a file with atlases or pictures needs besides; null for other files, and for glossy ones. */
export function surfacesOf(gl, mesh) {
  const { transfer } = mesh.relighter.baked;
  const isPlain = transfer.albedoMaps.length === 0 && transfer.atlases.length === 0;
  return isPlain || transfer.isGlossy ? null : new Surfaces(gl, mesh);
}

/** The pictures of a mesh on the GPU, and its faces picture by picture. */
export class Pictures {
  constructor(gl, mesh) {
    const { transfer, pictures = [] } = mesh.relighter.baked;
    this.gl = gl;
    this.ids = pictures.map((picture) => this.upload(picture));
    this.groups = this.sortFaces(transfer, mesh.arrays);
  }

  upload(picture) {
    const { gl } = this;
    const id = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, id);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, picture);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    return id;
  }

  // Puts faces with one picture behind each other: [{first, count, picture}].
  sortFaces({ sections: { face, albmap = [] } }, arrays) {
    const { gl } = this;
    const faces = Array.from({ length: face.length / 3 }, (_, f) => f);
    const pictureOf = (f) => albmap[face[3 * f]] ?? 0;
    faces.sort((a, b) => pictureOf(a) - pictureOf(b) || a - b);
    const sorted = new Uint32Array(face.length);
    const groups = [];
    faces.forEach((f, place) => {
      sorted.set(face.subarray(3 * f, 3 * f + 3), 3 * place);
      const picture = pictureOf(f);
      if (groups.at(-1)?.picture !== picture) groups.push({ first: 3 * place, count: 0, picture });
      groups.at(-1).count += 3;
    });
    gl.bindVertexArray(arrays);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, sorted, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
    return groups;
  }

  /** Draws the faces by the program in use, which reads `picture` from this unit. */
  draw(program, unit) {
    const { gl } = this;
    gl.uniform1i(gl.getUniformLocation(program, 'picture'), unit);
    for (const { first, count, picture } of this.groups) {
      gl.uniform1i(gl.getUniformLocation(program, 'has_picture'), picture);
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, picture > 0 ? this.ids[picture - 1] : null);
      gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * first);
    }
    gl.activeTexture(gl.TEXTURE0);
  }
}

class Surfaces {
  constructor(gl, mesh) {
    this.gl = gl;
    this.mesh = mesh;
    const { transfer } = mesh.relighter.baked;
    if (transfer.atlases.length > kMostAtlases) {
      throw new FileError(`${transfer.atlases.length} atlases: a page shows at most ${kMostAtlases} in a file`);
    }
    this.vertices = transfer.vertices;
    this.textures = {};
    this.addAttributes(transfer);
    this.addReceivers(transfer);
    this.pictures = new Pictures(gl, mesh);
  }

  // Attributes of vertices, which stand for zeros where the file has none.
  addAttributes({ sections, vertices }) {
    const { chart = [], atlas = [], texture = [], tint = [], albedo, emitted = [] } = sections;
    const places = new Float32Array(3 * vertices);
    atlas.forEach((number, v) => places.set([chart[2 * v], chart[2 * v + 1], number], 3 * v));
    this.attribute(3, 3, places);
    [[4, 2, texture], [5, 3, tint], [6, 3, albedo], [7, 3, emitted]].forEach(([location, components, values]) => {
      const padded = new Float32Array(components * vertices);
      padded.set(values);
      this.attribute(location, components, padded);
    });
  }

  attribute(location, components, array) {
    const { gl } = this;
    gl.bindVertexArray(this.mesh.arrays);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, array, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, components, gl.FLOAT, false, 0, 0);
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
  }

  // Textures of all receivers, and the receivers of the pixels.
  addReceivers({ sections, atlases, vertices }) {
    const { gl } = this;
    const { albedo, emitted = new Float32Array(3 * vertices), texel = new Uint32Array(0) } = sections;
    this.numbers('radiances', new Float32Array(3 * vertices), gl.RGB32F, gl.RGB, gl.FLOAT, 3);
    this.numbers('albedos', albedo, gl.RGB32F, gl.RGB, gl.FLOAT, 3);
    this.numbers('emissions', emitted, gl.RGB32F, gl.RGB, gl.FLOAT, 3);
    this.atlases = new Int32Array(3 * kMostAtlases);
    const all = [];
    let entry = 0, first = 0;
    atlases.forEach((head, number) => {
      all.push(verticesOf(head, texel.subarray(entry, entry += head.texels)));
      this.atlases.set([first, head.width, head.height], 3 * number);
      first += head.width * head.height;
    });
    const receivers = new Uint32Array(first);
    all.forEach((vertices, number) => receivers.set(vertices, this.atlases[3 * number]));
    this.numbers('receivers', receivers, gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT, 1);
  }

  numbers(name, numbers, internal, layout, type, components) {
    const { gl } = this;
    const { rows, padded } = inRows(numbers, components);
    const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    if (rows > most || kWide > most) {
      throw new FileError(`its receivers need a texture of ${kWide} x ${rows}, this GPU has at most ${most} x ${most}: bake fewer texels`);
    }
    this.textures[name] = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.textures[name]);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, internal, kWide, rows, 0, layout, type, padded);
  }

  /** Makes the program ready that shades the pixels. */
  use(shaders) {
    const { gl, mesh } = this;
    this.program ??= programOf(gl, shaders['surfaces.vert'], `#version 300 es\n${shaders['tone.glsl']}${shaders['surfaces.frag']}`);
    mesh.relighter.refresh();
    this.copyRadiance();
    gl.useProgram(this.program);
    Object.entries(this.textures).forEach(([name, id], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, id);
      gl.uniform1i(gl.getUniformLocation(this.program, name), unit);
    });
    gl.uniform3iv(gl.getUniformLocation(this.program, 'atlases'), this.atlases);
    gl.bindVertexArray(mesh.arrays);
    return this.program;
  }

  // Whole rows, then the rest of the last one: the buffer ends with it.
  copyRadiance() {
    const { gl } = this;
    const rows = Math.floor(this.vertices / kWide), rest = this.vertices % kWide;
    gl.bindTexture(gl.TEXTURE_2D, this.textures.radiances);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, this.mesh.relighter.radiance);
    if (rows > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, kWide, rows, gl.RGB, gl.FLOAT, 0);
    if (rest > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, rows, rest, 1, gl.RGB, gl.FLOAT, 12 * kWide * rows);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
  }

  draw() { this.pictures.draw(this.program, Object.keys(this.textures).length); }
}
