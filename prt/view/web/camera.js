// An orbit about a target, z up, and its matrices. Angles in degrees; field of view vertical.
import { applied, cross, dotOf, inRadians, minus, plus, transposed, unit } from './vectors.js';
import { unplaced } from './stage.js';

/** Axes of the camera: right, up, backward. */
export function axesOf(camera) {
  const back = [Math.cos(inRadians(camera.pitch)) * Math.cos(inRadians(camera.yaw)),
                Math.cos(inRadians(camera.pitch)) * Math.sin(inRadians(camera.yaw)), Math.sin(inRadians(camera.pitch))];
  const right = [-Math.sin(inRadians(camera.yaw)), Math.cos(inRadians(camera.yaw)), 0];
  return { right, up: cross(back, right), back };
}

export const eyeOf = (camera) => plus(camera.target, axesOf(camera).back, camera.distance);

/** The orbit of a camera with position and target; its up is z. */
export function orbitOf({ position, target, field_of_view: fieldOfView }) {
  const back = minus(position, target);
  const distance = Math.hypot(...back);
  return { target, distance, yaw: (Math.atan2(back[1], back[0]) * 180) / Math.PI,
           pitch: Math.min(89.5, Math.max(-89.5, (Math.asin(back[2] / distance) * 180) / Math.PI)), fieldOfView };
}

/** The camera that `prt render` takes without a scene: the sphere around the box fits the picture. */
export function defaultOrbit({ center, radius }, aspect) {
  const fieldOfView = 40;
  const distance = radius / Math.sin(inRadians(0.5 * fieldOfView) * Math.min(1, aspect));
  return orbitOf({ position: plus(center, unit([0.5, -0.75, 0.45]), distance), target: center, field_of_view: fieldOfView });
}

// Column-major products for WebGL.
function perspective(fieldOfView, aspect, near, far) {
  const f = 1 / Math.tan(0.5 * inRadians(fieldOfView));
  return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, (2 * far * near) / (near - far), 0];
}

function matrixProduct(a, b) {
  return a.map((_, i) => [0, 1, 2, 3].reduce((sum, k) => sum + a[(i % 4) + 4 * k] * b[4 * Math.floor(i / 4) + k], 0));
}

function viewMatrix({ right, up, back }, eye) {
  return [right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0,
          -dotOf(right, eye), -dotOf(up, eye), -dotOf(back, eye), 1];
}

/**
 * Coordinates of a mesh to clip space. Its own are (p - origin) / unit of points p of an object that stands in this pose;
 * `bounds` is the sphere in the world that is between the two planes.
 */
export function toClip(camera, aspect, bounds, { origin, unit: size }, pose) {
  const depth = dotOf(minus(eyeOf(camera), bounds.center), axesOf(camera).back);
  const near = Math.max(depth - 1.01 * bounds.radius, 1e-3 * camera.distance);
  const far = Math.max(depth + 1.01 * bounds.radius, 2 * near);
  const back = transposed(pose.rotation);
  const axes = Object.fromEntries(Object.entries(axesOf(camera)).map(([name, axis]) => [name, applied(back, axis)]));
  return matrixProduct(perspective(camera.fieldOfView, aspect, near / size, far / size), viewMatrix(axes, localEye(camera, { origin, unit: size }, pose)));
}

/** The eye in the coordinates of such a mesh. */
export function localEye(camera, { origin, unit: size }, pose) {
  return minus(unplaced(pose, eyeOf(camera)), origin).map((x) => x / size);
}

/** Directions to clip space, for what is infinitely far away. */
export function directionsToClip(camera, aspect) {
  return matrixProduct(perspective(camera.fieldOfView, aspect, 0.1, 10), viewMatrix(axesOf(camera), [0, 0, 0]));
}

/** The direction through a point of the picture; x and y from -1 to 1, y upwards. */
export function rayThrough(camera, aspect, x, y) {
  const { right, up, back } = axesOf(camera);
  const half = Math.tan(0.5 * inRadians(camera.fieldOfView));
  return unit(plus(plus(back.map((b) => -b), right, x * half * aspect), up, y * half));
}
