// Objects of a stage: where they stand at a time, and the caps of the light that their spheres take from each other; as
// prt/scene/stage.hpp, prt/light/proxy_shadow.hpp and prt/runtime/relight_stage.hpp have it. A pose is {rotation, position}:
// world = rotation p + position.
import { applied, gaussLegendre, minus, plus, remembering, rotationAbout, toPole, transposed, unit } from './vectors.js';

/** The pose of an object without keys: at rest. */
const kRest = { rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], position: [0, 0, 0] };

export const isTurned = ({ rotation }) => rotation.some((x, i) => x !== kRest.rotation[i]);

/** Position and angle are linear between keys, and constant before the first and after the last one. */
export function poseAt({ axis, keys }, time) {
  if (!keys) return kRest;
  const after = keys.findIndex((key) => key.time > time);
  const next = after < 0 ? keys.at(-1) : keys[after];
  const last = after < 0 ? keys.at(-1) : keys[Math.max(after - 1, 0)];
  const span = next.time - last.time;
  const part = span > 0 ? (time - last.time) / span : 0;
  return { rotation: rotationAbout(axis, last.degrees + part * (next.degrees - last.degrees)),
           position: plus(last.position, minus(next.position, last.position), part) };
}

export const placed = ({ rotation, position }, point) => plus(applied(rotation, point), position);

/** A point of the world in the axes of an object. */
export const unplaced = ({ rotation, position }, point) => applied(transposed(rotation), minus(point, position));

function capSeenFrom(from, center, radius) {
  const towards = minus(center, from);
  const distance = Math.hypot(...towards);
  if (!(distance > 0)) return { direction: [0, 0, 1], oneMinusCos: 1 };
  const q = (radius / distance) ** 2;
  return { direction: unit(towards), oneMinusCos: distance > radius ? q / (1 + Math.sqrt(1 - q)) : 1 };
}

/** The caps that the other objects without a volume cover as seen from a point of the world, in the axes of object `index`. */
export function capsSeenFrom(objects, poses, index, point) {
  const back = transposed(poses[index].rotation);
  return objects.flatMap(({ proxy, volume }, k) => {
    if (k === index || volume || !(proxy?.radius > 0)) return [];
    const cap = capSeenFrom(point, placed(poses[k], proxy.center), proxy.radius);
    return [{ ...cap, direction: unit(applied(back, cap.direction)) }];
  });
}

const kRules = remembering((degree) => gaussLegendre(degree + 1));

/**
 * A function of one channel without its part from a cap, projected on its bands up to `highest`; above them it is zero.
 * The projection is a symmetric matrix: what it does to a row of transfer is as good as what it does to the light.
 */
export function withoutCap({ rotate, basis }, highest, values, { direction, oneMinusCos }) {
  if (oneMinusCos === 0) return values;
  const pole = toPole(direction);
  const [seen, ring, out] = [0, 1, 2].map(() => new Float64Array(values.length));
  rotate(pole, values, seen);
  const rest = seen.slice();
  for (const [node, weight] of kRules(highest)) {
    const down = 0.5 * oneMinusCos * (1 + node);
    basis(Math.sqrt(Math.max(0, down * (2 - down))), 0, 1 - down, ring);  // at azimuth 0
    const factor = 0.5 * Math.PI * oneMinusCos * weight;
    for (let m = -highest; m <= highest; ++m) {
      const order = Math.abs(m);
      let sum = 0;
      for (let l = order; l <= highest; ++l) sum += ring[l * (l + 1) + order] * seen[l * (l + 1) + m];
      sum *= m === 0 ? 2 * factor : factor;
      for (let l = order; l <= highest; ++l) rest[l * (l + 1) + m] -= sum * ring[l * (l + 1) + order];
    }
  }
  rotate(transposed(pole), rest, out);
  return out;
}
