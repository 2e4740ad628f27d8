// The vertex under the pointer: the nearest face that a ray meets, and of its corners the nearest.
import { cross, dotOf, minus, plus } from './vectors.js';

// The distance along a ray to a triangle [Moeller, Trumbore, 1997]; Infinity if it misses.
function distanceTo(origin, direction, a, b, c) {
  const ab = minus(b, a), ac = minus(c, a);
  const p = cross(direction, ac);
  const volume = dotOf(ab, p);
  if (volume === 0) return Infinity;
  const from = minus(origin, a);
  const u = dotOf(from, p) / volume;
  const q = cross(from, ab);
  const v = dotOf(direction, q) / volume;
  const t = dotOf(ac, q) / volume;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : Infinity;
}

/** origin and direction in the coordinates of the mesh -> {vertex, distance} along the direction, or null. */
export function vertexAlong({ sections: { position, face } }, origin, direction) {
  const point = (v) => [position[3 * v], position[3 * v + 1], position[3 * v + 2]];
  let nearest = Infinity, hit = -1;
  for (let f = 0; f < face.length; f += 3) {
    const t = distanceTo(origin, direction, point(face[f]), point(face[f + 1]), point(face[f + 2]));
    if (t < nearest) [nearest, hit] = [t, f];
  }
  if (hit < 0) return null;
  const place = plus(origin, direction, nearest);
  const apart = (v) => Math.hypot(...minus(point(v), place));
  const corners = [face[hit], face[hit + 1], face[hit + 2]];
  return { vertex: corners.reduce((best, v) => (apart(v) < apart(best) ? v : best)), distance: nearest };
}
