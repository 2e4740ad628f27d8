// An orbit about a target, z up, and its matrices. Angles in degrees; field of view vertical.
const inRadians = (degrees) => (degrees * Math.PI) / 180;

export const minus = (a, b) => a.map((x, k) => x - b[k]);
export const plus = (a, b, factor = 1) => a.map((x, k) => x + factor * b[k]);
export const dotOf = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a) => { const size = Math.hypot(...a); return a.map((x) => x / size); };

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

/** Coordinates of a mesh in a sphere `bounds`, whose own are (world - origin) / unit, to clip space. */
export function toClip(camera, aspect, bounds, { origin, unit: size }) {
  const eye = eyeOf(camera);
  const depth = dotOf(minus(eye, bounds.center), axesOf(camera).back);
  const near = Math.max(depth - 1.01 * bounds.radius, 1e-3 * camera.distance);
  const far = Math.max(depth + 1.01 * bounds.radius, 2 * near);
  const local = minus(eye, origin).map((x) => x / size);
  return matrixProduct(perspective(camera.fieldOfView, aspect, near / size, far / size), viewMatrix(axesOf(camera), local));
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
