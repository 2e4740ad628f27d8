// Draws relit meshes, and measures the exposure as `prt render` does.
import { programOf } from './relight.js';
import { minus } from './vectors.js';
import { AtlasTexels } from './atlas.js';
import { Pictures, surfacesOf } from './surfaces.js';

export const kTones = ['neutral', 'reinhard', 'linear'];

/** The sphere around the box of points; each(visit) calls visit(point) for them. */
export function sphereAround(each) {
  const least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity];
  each((point) => point.forEach((x, k) => {
    least[k] = Math.min(least[k], x);
    most[k] = Math.max(most[k], x);
  }));
  return { center: least.map((x, k) => (x + most[k]) / 2), radius: Math.hypot(...minus(most, least)) / 2 };
}

/** The color of what is not covered by the mesh: 0.3 after exposure, as `prt render` has it. */
export function greyOf(tone) {
  const linear = { neutral: 0.3 - 0.04, reinhard: 0.3 / 1.3, linear: 0.3 }[tone];
  return 1.055 * linear ** (1 / 2.4) - 0.055;
}

/** The factor that brings the 95th percentile of the brightest channels to 0.7; 1 if everything is black. */
export function exposureOf(brightest) {
  const sorted = Float32Array.from(brightest).sort();
  const value = sorted[Math.floor(0.95 * (sorted.length - 1))];
  return value > 0 ? 0.7 / value : 1;
}

/** A mesh on the GPU beside its Relighter. */
export class DrawnMesh {
  constructor(gl, relighter) {
    this.gl = gl;
    this.relighter = relighter;
    this.count = relighter.baked.transfer.sections.face.length;
    this.indices = gl.createBuffer();
    this.arrays = gl.createVertexArray();
    this.giveFaces(this.arrays);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, relighter.baked.transfer.sections.face, gl.STATIC_DRAW);
    this.giveFaces(relighter.arrays);
    this.point(0, relighter.buffers.position);
    this.point(1, relighter.radiance);
    this.point(2, relighter.radiance);
    this.surfaces = surfacesOf(gl, this);
    const { transfer, runtime } = relighter.baked;
    this.pictures = this.hasPixels && transfer.albedoMaps.length > 0 ? new Pictures(gl, this) : null;
    this.texels = this.hasPixels && runtime.shaders.pixels.texels ? new AtlasTexels(gl, transfer) : null;
  }

  giveFaces(arrays) {
    this.gl.bindVertexArray(arrays);
    this.gl.bindBuffer(this.gl.ELEMENT_ARRAY_BUFFER, this.indices);
  }

  point(location, buffer) {
    const gl = this.gl;
    gl.bindVertexArray(this.arrays);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 0, 0);
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);  // else relighting may not write it
  }

  /** The other transfer of a difference. */
  compareWith(relighter) {
    relighter.refresh();
    this.point(2, relighter.radiance);
  }

  /** Whether its pixels are shaded, not its vertices: glossy ones, where the GPU hands on so many numbers. */
  get hasPixels() {
    const { pixels } = this.relighter.baked.runtime.shaders;
    return Boolean(pixels) && pixels.vectors <= this.gl.getParameter(this.gl.MAX_VARYING_VECTORS);
  }

  /** Draws its faces by the program in use; hasPictures: with pictures of the albedo, if it has any. */
  drawFaces(program, hasPictures) {
    const { gl } = this;
    if (hasPictures && this.surfaces) return this.surfaces.draw();
    if (hasPictures && this.pictures) return this.pictures.draw(program, this.units);
    return gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_INT, 0);
  }

  /** The texture units that the relighter takes. */
  get units() { return Object.keys(this.relighter.textures).length; }

  pixelProgram(shaders) {
    const { vertex, fragment } = this.relighter.baked.runtime.shaders.pixels;
    this.program ??= programOf(this.gl, vertex, `${fragment}\n${shaders['tone.glsl']}${shaders['picture_pixels.frag']}`);
    return this.program;
  }
}

export class Picture {
  constructor(gl, shaders) {
    this.gl = gl;
    this.shaders = shaders;
    this.program = programOf(gl, shaders['picture.vert'], `#version 300 es\n${shaders['tone.glsl']}${shaders['picture.frag']}`);
  }

  // Mode 1 compares vertices: it takes their radiance.
  use(mesh, mode) {
    const gl = this.gl;
    if (mode !== 1 && mesh.hasPixels) {
      const program = mesh.pixelProgram(this.shaders);
      mesh.relighter.use(program, mesh.relighter.arrays);
      mesh.texels?.use(program, mesh.units + 1);
      return program;
    }
    if (mode !== 1 && mesh.surfaces) return mesh.surfaces.use(this.shaders);
    mesh.relighter.refresh();
    gl.useProgram(this.program);
    gl.bindVertexArray(mesh.arrays);
    return this.program;
  }

  /**
   * Draws a relit mesh over what is there. Where two sides of a sheet coincide, the one that faces the eye is seen.
   * mode: 0 the picture, 1 false colors of the difference, 2 radiance.
   */
  draw(mesh, { toClip, exposure = 1, tone = 'neutral', mode = 0, reference = 1 }) {
    const gl = this.gl;
    const program = this.use(mesh, mode);
    const place = (name) => gl.getUniformLocation(program, name);
    gl.uniformMatrix4fv(place('to_clip'), false, toClip);
    gl.uniform1f(place('exposure'), exposure);
    gl.uniform1i(place('tone'), kTones.indexOf(tone));
    gl.uniform1i(place('mode'), mode);
    gl.uniform1f(place('reference'), reference);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.CULL_FACE);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    for (const [side, offset] of [[gl.FRONT, 1], [gl.BACK, 0]]) {
      gl.cullFace(side);
      gl.polygonOffset(offset, offset);
      mesh.drawFaces(program, mode !== 1);
    }
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.disable(gl.CULL_FACE);
    gl.bindVertexArray(null);
  }

  /** The exposure of a small picture that draw(mode) draws; without buffers of floats that of the vertices' radiance(). */
  measure(draw, radiance) {
    const gl = this.gl;
    const width = 240, height = 135;
    if (!gl.getExtension('EXT_color_buffer_float')) return exposureOf(radiance());
    const target = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    const buffers = [[gl.RGBA32F, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]].map(([format, point]) => {
      const buffer = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, point, gl.RENDERBUFFER, buffer);
      return buffer;
    });
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    draw(2);
    const pixels = new Float32Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, pixels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(target);
    buffers.forEach((buffer) => gl.deleteRenderbuffer(buffer));
    const brightest = [];
    for (let i = 0; i < pixels.length; i += 4) {
      if (pixels[i + 3] === 1) brightest.push(Math.max(pixels[i], pixels[i + 1], pixels[i + 2]));
    }
    return brightest.length > 0 ? exposureOf(brightest) : 1;
  }
}
