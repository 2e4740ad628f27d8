// Vectors of three numbers, and rotations: 9 numbers, row by row. Right-handed, angles in degrees.

export const inRadians = (degrees) => (degrees * Math.PI) / 180;

export const minus = (a, b) => a.map((x, k) => x - b[k]);
export const plus = (a, b, factor = 1) => a.map((x, k) => x + factor * b[k]);
export const dotOf = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a) => { const size = Math.hypot(...a); return a.map((x) => x / size); };

/** r v. */
export const applied = (r, v) => [0, 3, 6].map((row) => r[row] * v[0] + r[row + 1] * v[1] + r[row + 2] * v[2]);

export const transposed = (r) => r.map((_, i) => r[3 * (i % 3) + Math.floor(i / 3)]);

/** The rotation a after b. */
export const composed = (a, b) => transposed([0, 1, 2].flatMap((k) => applied(a, [b[k], b[3 + k], b[6 + k]])));

/** The rotation by an angle about a unit axis. */
export function rotationAbout([x, y, z], degrees) {
  const c = Math.cos(inRadians(degrees)), s = Math.sin(inRadians(degrees)), t = 1 - c;
  return [t * x * x + c, t * x * y - s * z, t * x * z + s * y, t * x * y + s * z, t * y * y + c, t * y * z - s * x,
          t * x * z - s * y, t * y * z + s * x, t * z * z + c];
}

/** A rotation that takes a unit direction to +z. */
export function toPole(direction) {
  const x = unit(cross(Math.abs(direction[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0], direction));
  return [...x, ...cross(direction, x), ...direction];
}

/** Nodes and weights on [-1, 1] [Gauss-Legendre], by Newton's method on P_n. */
export function gaussLegendre(n) {
  return Array.from({ length: n }, (_, k) => {
    let z = Math.cos((Math.PI * (k + 0.75)) / (n + 0.5)), slope = 1;
    for (let step = 0; step < 8; ++step) {
      let p = 1, before = 0;
      for (let l = 0; l < n; ++l) [p, before] = [((2 * l + 1) * z * p - l * before) / (l + 1), p];
      slope = (n * (z * p - before)) / (z * z - 1);
      z -= p / slope;
    }
    return [z, 2 / ((1 - z * z) * slope * slope)];
  });
}

/** A function of whole numbers whose values are computed once. */
export function remembering(make) {
  const values = new Map();
  return (key) => {
    if (!values.has(key)) values.set(key, make(key));
    return values.get(key);
  };
}
