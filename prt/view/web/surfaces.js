// Diffuse surfaces pixel by pixel: light between the texels of an atlas, and the picture of the albedo over it, as
// prt/rays/receivers_at.hpp and prt/runtime/surface_colors.hpp have it.
import { FileError } from './transfer_file.js';
import { programOf } from './relight.js';
import { AtlasTexels, kWide, placesInAtlases, wideTexture } from './atlas.js';

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
    this.vertices = transfer.vertices;
    this.textures = {};
    this.addAttributes(transfer);
    this.addReceivers(transfer);
    this.texels = new AtlasTexels(gl, transfer);
    this.pictures = new Pictures(gl, mesh);
  }

  // Attributes of vertices, which stand for zeros where the file has none.
  addAttributes(transfer) {
    const { texture = [], tint = [], albedo, emitted = [] } = transfer.sections;
    this.attribute(3, 3, placesInAtlases(transfer));
    [[4, 2, texture], [5, 3, tint], [6, 3, albedo], [7, 3, emitted]].forEach(([location, components, values]) => {
      const padded = new Float32Array(components * transfer.vertices);
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

  addReceivers({ sections, vertices }) {
    const { gl } = this;
    const { albedo, emitted = new Float32Array(3 * vertices) } = sections;
    for (const [name, numbers] of [['radiances', new Float32Array(3 * vertices)], ['albedos', albedo], ['emissions', emitted]]) {
      this.textures[name] = wideTexture(gl, numbers, { internal: gl.RGB32F, layout: gl.RGB, type: gl.FLOAT, components: 3 });
    }
  }

  /** Makes the program ready that shades the pixels. */
  use(shaders) {
    const { gl, mesh } = this;
    this.program ??= programOf(gl, shaders['surfaces.vert'], `#version 300 es\n${shaders['tone.glsl']}${shaders['atlas.glsl']}${shaders['surfaces.frag']}`);
    mesh.relighter.refresh();
    this.copyRadiance();
    gl.useProgram(this.program);
    Object.entries(this.textures).forEach(([name, id], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, id);
      gl.uniform1i(gl.getUniformLocation(this.program, name), unit);
    });
    this.texels.use(this.program, this.units);
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

  get units() { return Object.keys(this.textures).length; }

  draw() { this.pictures.draw(this.program, this.units + 1); }
}
