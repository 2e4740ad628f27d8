// What lies over the picture and beside it: the divider, labels, the marker and the numbers of the vertex, facts and time.
import { nodeOf, numbersOf } from './transfer_file.js';
import { turned } from './relight.js';
import { spiralOf } from './light.js';
import { isTurned, placed } from './stage.js';
import { applied } from './vectors.js';
import { showVertex } from './panel.js';
import { remembered } from './lighting.js';

const kMeanings = {
  DU: 'transfer vector: its product with the light, times the albedo, is the radiance', DI: 'transfer vectors: their products with the light are the radiance',
  GS: 'visibility: 1 where the vertex sees the sky', GU: 'nothing: the light itself reaches the vertex',
};
kMeanings.DS = kMeanings.DU;
kMeanings.DT = kMeanings.DI;
kMeanings.GI = kMeanings.GS;

export const element = (id) => document.getElementById(id);

/** One line for the user; empty: none. */
export function tell(line) {
  element('message').textContent = line;
  element('message').hidden = line === '';
}

export function showTheme({ theme }) {
  const dark = theme === 'dark' || (theme === 'system' && matchMedia('(prefers-color-scheme: dark)').matches);
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
}

export function accentColor() {
  const hex = getComputedStyle(document.documentElement).getPropertyValue('--accent').trim();
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);
}

const kLobes = remembered();

// The largest absolute value of a light's green at the points of a spiral.
function mostOf(kernels, light) {
  const rgb = [0, 0, 0];
  return spiralOf(5).reduce((most, point) => {
    kernels[`evaluate_rgb_l${light.degree}`](light.values, ...point, rgb);
    return Math.max(most, Math.abs(rgb[1]));
  }, 1e-30);
}

/** The transfer of a vertex as a function on the sphere, in the axes of the world: {light, most}, most its largest absolute value. */
export function lobeOf(kernels, subject, vertex) {
  if (vertex < 0) return null;
  const { object: { transfer }, index, pose } = subject.at(vertex);
  if (transfer.shape.count === 0) return null;
  return kLobes(JSON.stringify([subject.number, vertex, pose.rotation]), () => {
    const numbers = numbersOf(transfer, index);
    const degree = Math.sqrt(transfer.shape.columns) - 1;
    const own = { degree, values: transfer.shape.channels === 3 ? numbers : Float64Array.from([...numbers, ...numbers, ...numbers]) };
    const light = isTurned(pose) ? turned(kernels, own, pose.rotation) : own;
    return { light, most: mostOf(kernels, light) };
  });
}

/** The time from `began` until the GPU has drawn. */
export function showTime(gl, began) {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  const look = () => {
    if (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) return setTimeout(look, 1);
    gl.deleteSync(fence);
    element('time').textContent = `${(performance.now() - began).toFixed(1)} ms`;
    return undefined;
  };
  setTimeout(look, 0);
}

/** Divider, labels, scale and spheres. */
export function showComparison({ wipe, compare, balls }, [first, second], isDifference, hasLobe) {
  element('divider').hidden = compare !== 'wipe';
  element('divider').style.left = `${100 * wipe}%`;
  element('left').textContent = first.name;
  element('right').textContent = second.name;
  element('scale').hidden = !isDifference;
  element('balls').hidden = !balls;
  element('ball-lobe').hidden = !hasLobe;
  element('facts').textContent = first.facts;
}

/** The marker at the chosen vertex, and its numbers. clip(place): the matrix from object `place` to clip space. */
export function showChosen(subject, vertex, { clientWidth, clientHeight }, clip) {
  element('marker').hidden = vertex < 0;
  if (vertex < 0) {
    element('vertex').innerHTML = '<p class="note">Click the mesh.</p>';
    return;
  }
  const { object, place, index, pose } = subject.at(vertex);
  const { transfer } = object;
  const three = (name) => [...transfer.sections[name].subarray(3 * index, 3 * index + 3)];
  const m = clip(place);
  const [x, y, , w] = [0, 1, 2, 3].map((row) => [...three('position'), 1].reduce((total, value, k) => total + m[row + 4 * k] * value, 0));
  element('marker').style.left = `${((x / w + 1) / 2) * clientWidth}px`;
  element('marker').style.top = `${((1 - y / w) / 2) * clientHeight}px`;
  showVertex(element('vertex'), {
    name: subject.isStage ? object.file.name : '', node: nodeOf(transfer, index), vertex, position: placed(pose, object.point(index)), normal: applied(pose.rotation, three('normal')),
    radiance: object.relighter.read(index, 1), numbers: numbersOf(transfer, index), shape: transfer.shape, meaning: kMeanings[transfer.kind],
  });
}
