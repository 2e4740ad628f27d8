// Draws relit meshes, and measures the exposure as `prt render` does.
import { programOf } from './relight.js';

const kTones = ['neutral', 'reinhard', 'linear'];

/** The sphere around the box of the positions, in the world. */
export function boundsOf({ sections: { position }, frame: { origin, unit } }) {
  const least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity];
  position.forEach((x, i) => {
    least[i % 3] = Math.min(least[i % 3], x);
    most[i % 3] = Math.max(most[i % 3], x);
  });
  const center = least.map((x, k) => origin[k] + (unit * (x + most[k])) / 2);
  return { center, radius: (unit * Math.hypot(...least.map((x, k) => most[k] - x))) / 2 };
}

/** The factor that brings the 95th percentile of the brightest channels to 0.7; 1 if everything is black. */
export function exposureOf(brightest) {
  const sorted = Float32Array.from(brightest).sort();
  const value = sorted[Math.floor(0.95 * (sorted.length - 1))];
  return value > 0 ? 0.7 / value : 1;
}

function lookUp(gl, program, names) {
  return Object.fromEntries(names.map((name) => [name, gl.getUniformLocation(program, name)]));
}

/** A mesh on the GPU beside its Relighter. */
export class DrawnMesh {
  constructor(gl, relighter) {
    this.gl = gl;
    this.relighter = relighter;
    this.indices = gl.createBuffer();
    this.count = relighter.baked.transfer.sections.face.length;
    this.arrays = gl.createVertexArray();
    gl.bindVertexArray(this.arrays);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, relighter.baked.transfer.sections.face, gl.STATIC_DRAW);
    this.point(0, relighter.buffers.position);
    this.point(1, relighter.radiance);
    this.compareWith(relighter);
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
  compareWith(relighter) { this.point(2, relighter.radiance); }
}

export class Picture {
  constructor(gl, shaders) {
    this.gl = gl;
    this.program = programOf(gl, shaders['picture.vert'], `#version 300 es\n${shaders['tone.glsl']}${shaders['picture.frag']}`);
    this.uniforms = lookUp(gl, this.program, ['to_clip', 'exposure', 'tone', 'mode', 'reference']);
  }

  /** Draws a mesh over what is there. Where two sides of a sheet coincide, the one that faces the eye is seen. */
  draw(mesh, { toClip, exposure = 1, tone = 'neutral', mode = 0, reference = 1 }) {
    const gl = this.gl;
    gl.useProgram(this.program);
    gl.uniformMatrix4fv(this.uniforms.to_clip, false, toClip);
    gl.uniform1f(this.uniforms.exposure, exposure);
    gl.uniform1i(this.uniforms.tone, kTones.indexOf(tone));
    gl.uniform1i(this.uniforms.mode, mode);
    gl.uniform1f(this.uniforms.reference, reference);
    gl.bindVertexArray(mesh.arrays);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.CULL_FACE);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    for (const [side, offset] of [[gl.FRONT, 1], [gl.BACK, 0]]) {
      gl.cullFace(side);
      gl.polygonOffset(offset, offset);
      gl.drawElements(gl.TRIANGLES, mesh.count, gl.UNSIGNED_INT, 0);
    }
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.disable(gl.CULL_FACE);
    gl.bindVertexArray(null);
  }

  /** The exposure of a small picture of linear radiance; without buffers of floats that of the vertices. */
  measure(mesh, toClip) {
    const gl = this.gl;
    const width = 240, height = 135;
    if (!gl.getExtension('EXT_color_buffer_float')) return exposureOf(mesh.relighter.read());
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
    this.draw(mesh, { toClip, mode: 2 });
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
