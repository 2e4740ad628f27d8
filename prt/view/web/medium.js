// A medium that is shown: its points are relit like the vertices of a mesh, and rays go through its grid.
import { FileError } from './transfer_file.js';
import { programOf, Relighter } from './relight.js';
import { axesOf, eyeOf } from './camera.js';
import { kTones } from './picture.js';
import { naming } from './subject.js';
import { lightText, setLight } from './ball.js';
import { inRadians, minus } from './vectors.js';

/** A subject like those of subject.js. kernelTexts: the page's. */
export class Medium {
  constructor(gl, { name }, file, number, kernelTexts) {
    Object.assign(this, { gl, name, number, file, kernelTexts });
    this.transfer = file.baked.transfer;
    this.isStage = this.moves = this.isGlossy = false;
    this.dependsOnEye = this.transfer.shape.rows > 1;
    const { box: [low, high], counts } = this.transfer.grid;
    this.bounds = { center: low.map((x, k) => (x + high[k]) / 2), radius: Math.hypot(...minus(high, low)) / 2 };
    this.vertices = this.transfer.vertices;
    this.bytes = file.bytes;
    const most = gl.getParameter(gl.MAX_3D_TEXTURE_SIZE);
    if (Math.max(...counts) > most) {
      throw new FileError(`${file.name}: a grid of ${counts.join(' x ')} points, this GPU has at most ${most} along an axis: bake fewer voxels`);
    }
    this.relighter = naming(file.name, () => new Relighter(gl, file.baked));
    // Where the GPU does not interpolate single precision, half of it serves.
    const isSingle = gl.getExtension('OES_texture_float_linear') !== null;
    this.sent = this.volume(isSingle ? gl.RGB32F : gl.RGB16F);
    this.extinction = this.volume(isSingle ? gl.R32F : gl.R16F);
    const { density } = this.transfer.sections;
    this.densest = density.reduce((largest, value) => Math.max(largest, value), 0);
    const scaled = density.map((value) => (this.densest > 0 ? value / this.densest : 0));
    gl.texSubImage3D(gl.TEXTURE_3D, 0, 0, 0, 0, ...counts, gl.RED, gl.FLOAT, scaled);
  }

  // A texture of the grid; it is bound then.
  volume(format) {
    const { gl, transfer: { grid: { counts } } } = this;
    const id = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_3D, id);
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T, gl.TEXTURE_WRAP_R]) gl.texParameteri(gl.TEXTURE_3D, side, gl.CLAMP_TO_EDGE);
    for (const size of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_3D, size, gl.LINEAR);
    gl.texStorage3D(gl.TEXTURE_3D, 1, format, ...counts);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    return id;
  }

  place() {}

  /** The eye of a camera, in cells from the first point. */
  eyeOf(camera) {
    const { box: [low, high], counts } = this.transfer.grid;
    return minus(eyeOf(camera), low).map((x, k) => (x * (counts[k] - 1)) / (high[k] - low[k]));
  }

  relight(light, _, camera) {
    const { gl, relighter, transfer: { grid: { counts } } } = this;
    relighter.relight(light, { eye: this.eyeOf(camera) });
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_3D, this.sent);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, relighter.radiance);
    gl.texSubImage3D(gl.TEXTURE_3D, 0, 0, 0, 0, ...counts, gl.RGB, gl.FLOAT, 0);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
  }

  /** Radiance that the points send, (points, 3). */
  read() { return this.relighter.read(); }

  programFor(degree, shaders) {
    if (this.degree !== degree) {
      if (this.program) this.gl.deleteProgram(this.program);
      this.program = programOf(this.gl, shaders['medium.vert'],
        `#version 300 es\n${shaders['tone.glsl']}${lightText(shaders, this.kernelTexts, degree)}${shaders['medium.frag']}`);
      this.degree = degree;
    }
    return this.program;
  }

  /** Draws what it sends over what is behind: the light of `look`, or grey. */
  draw(picture, camera, aspect, { exposure = 1, tone = 'neutral', mode = 0, light }) {
    const { gl, transfer: { grid: { box: [low, high], counts } } } = this;
    const program = this.programFor(light.degree, picture.shaders);
    const at = (name) => gl.getUniformLocation(program, name);
    const cells = counts.map((n, k) => (n - 1) / (high[k] - low[k]));
    const { right, up, back } = axesOf(camera);
    const axes = [right, up, back.map((x) => -x)];
    const height = Math.tan(0.5 * inRadians(camera.fieldOfView));
    gl.useProgram(program);
    setLight(gl, program, light);
    [['sent', this.sent], ['extinction', this.extinction]].forEach(([name, id], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_3D, id);
      gl.uniform1i(at(name), unit);
    });
    gl.uniform3iv(at('counts'), counts);
    gl.uniform3fv(at('eye'), this.eyeOf(camera));
    gl.uniformMatrix3fv(at('to_cells'), false, axes.flatMap((axis) => axis.map((x, k) => x * cells[k])));
    gl.uniformMatrix3fv(at('to_world'), false, axes.flat());
    gl.uniform2f(at('half_size'), height * aspect, height);
    gl.uniform1f(at('densest'), this.densest);
    gl.uniform1f(at('exposure'), exposure);
    gl.uniform1i(at('tone'), kTones.indexOf(tone));
    gl.uniform1i(at('mode'), mode);
    gl.uniform1i(at('lit_behind'), camera.background === 'light' ? 1 : 0);
    gl.disable(gl.DEPTH_TEST);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** It has no vertices to choose. */
  pick() { return -1; }

  /** No difference by vertices, as of meshes. */
  isLike() { return false; }

  get facts() {
    const { grid: { counts }, kind, shape } = this.transfer;
    return `${kind}, degree ${shape.degree}, ${shape.element} · ${counts.map((n) => n - 2).join(' x ')} voxels · ${(this.bytes / 2 ** 20).toFixed(2)} MiB`;
  }
}
