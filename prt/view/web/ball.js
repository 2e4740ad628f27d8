// Draws functions on the sphere: the light as a ball or as the background, transfer as a lobe.
import { programOf } from './relight.js';
import { axesOf } from './camera.js';
import { kTones } from './picture.js';

const kColumns = 96, kRows = 48;
const kHead = '#version 300 es\n';

/** light.glsl with the generated function of a degree. */
export function lightText(shaders, kernelTexts, degree) {
  const name = `evaluate_rgb_l${degree}`;
  return `${kernelTexts[name]}#define COUNT ${(degree + 1) ** 2}\n#define EVALUATE ${name}\n${shaders['light.glsl']}`;
}

/** Sets the function of light.glsl. */
export function setLight(gl, program, { values }) {
  const n = values.length / 3;
  gl.uniform3fv(gl.getUniformLocation(program, 'coefficients'), Float32Array.from(values, (_, i) => values[(i % 3) * n + Math.floor(i / 3)]));
}

export class Balls {
  constructor(gl, shaders, kernelTexts) {
    this.gl = gl;
    this.shaders = shaders;
    this.kernelTexts = kernelTexts;
    this.programs = new Map();
    this.arrays = gl.createVertexArray();
  }

  programFor(degree) {
    if (!this.programs.has(degree)) {
      const defines = `#define COLUMNS ${kColumns}\n#define ROWS ${kRows}\n`;
      this.programs.set(degree, programOf(this.gl,
        `${kHead}precision highp float;\nprecision highp int;\n${lightText(this.shaders, this.kernelTexts, degree)}${defines}${this.shaders['ball.vert']}`,
        `${kHead}${this.shaders['tone.glsl']}${this.shaders['ball.frag']}`));
    }
    return this.programs.get(degree);
  }

  /** `light` is {degree, values (3, bands^2)}; lobe: 0 for a ball, else the factor on the distance from the middle. */
  draw(light, { toClip, exposure, tone, lobe = 0, accent = [0, 0, 0], depth = true }) {
    const gl = this.gl;
    const program = this.programFor(light.degree);
    const at = (name) => gl.getUniformLocation(program, name);
    gl.useProgram(program);
    setLight(gl, program, light);
    gl.uniformMatrix4fv(at('to_clip'), false, toClip);
    gl.uniform1f(at('lobe'), lobe);
    gl.uniform1f(at('exposure'), exposure);
    gl.uniform1i(at('tone'), kTones.indexOf(tone));
    gl.uniform1i(at('mode'), lobe > 0 ? 1 : depth ? 0 : 2);
    gl.uniform3fv(at('accent'), accent);
    gl.bindVertexArray(this.arrays);
    depth ? gl.enable(gl.DEPTH_TEST) : gl.disable(gl.DEPTH_TEST);
    gl.drawArrays(gl.TRIANGLES, 0, 6 * kColumns * kRows);
    gl.bindVertexArray(null);
  }

  /**
   * The light as seen from outside, and a lobe {light, most, accent} or null beside it: in the lower left corner, turned as
   * the camera sees them. scale: pixels of the GPU a pixel of the page.
   */
  drawCorner(camera, scale, look, light, lobe) {
    const gl = this.gl;
    const isNarrow = window.innerWidth <= 720;  // as style.css has it
    const size = (isNarrow ? 88 : 128) * scale;
    const { right, up, back } = axesOf(camera);
    const toBall = [0, 1, 2].flatMap((k) => [0.95 * right[k], 0.95 * up[k], -0.5 * back[k], 0]).concat(0, 0, 0, 1);
    [[light, {}], ...(lobe ? [[lobe.light, { lobe: 1 / lobe.most, accent: lobe.accent }]] : [])].forEach(([of, more], column) => {
      const [x, y] = [(12 + column * (size / scale + 12)) * scale, (isNarrow ? 22 : 50) * scale];
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(x, y, size, size);
      gl.clear(gl.DEPTH_BUFFER_BIT);
      gl.disable(gl.SCISSOR_TEST);
      gl.viewport(x, y, size, size);
      this.draw(of, { ...look, ...more, toClip: toBall });
    });
  }
}
