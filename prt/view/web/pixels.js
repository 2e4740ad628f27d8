// What glossy surfaces need to be shaded pixel by pixel: places in the pictures of their albedo and, under normal maps,
// textures, places in atlases, and tangents of the vertices as prt/runtime/shading_normals.cpp has them.
import { texture } from './relight.js';
import { placesInAtlases } from './atlas.js';
import { cross, dotOf, minus, plus, unit } from './vectors.js';

const rowOf = (array, width, row) => [...array.subarray(width * row, width * (row + 1))];

// How the texture coordinates lie on a face: alongU is unit, or zero where they have no area.
function layoutOf({ position, texture: coordinates }, [a, b, c]) {
  const [s, t] = [b, c].map((v) => minus(rowOf(coordinates, 2, v), rowOf(coordinates, 2, a)));
  const [p, q] = [b, c].map((v) => minus(rowOf(position, 3, v), rowOf(position, 3, a)));
  const area = s[0] * t[1] - s[1] * t[0];
  const longest = Math.max(...[s, t, minus(t, s)].map(([x, y]) => x * x + y * y));
  if (!(Math.abs(area) > 1e-7 * longest)) return { alongU: [0, 0, 0], isMirrored: false };
  const along = p.map((x, k) => (t[1] * x - s[1] * q[k]) / area);
  return { alongU: Math.hypot(...along) > 0 ? unit(along) : along, isMirrored: area < 0 };
}

function perpendicular(direction, normal) {
  const rest = plus(direction, normal, -dotOf(normal, direction));
  return Math.hypot(...rest) > 1e-4 ? unit(rest) : [0, 0, 0];
}

function cornerAngle(position, corner, next, last) {
  const [a, b] = [next, last].map((v) => minus(rowOf(position, 3, v), rowOf(position, 3, corner)));
  return Math.atan2(Math.hypot(...cross(a, b)), dotOf(a, b));
}

// Of the faces around each vertex that show the picture, and of those that mirror it: unit, or zero.
function tangentsOf({ vertices, sections }) {
  const { position, normal, face } = sections;
  const sums = [0, 1].map(() => new Float32Array(3 * vertices));
  for (let f = 0; f < face.length; f += 3) {
    const corners = [face[f], face[f + 1], face[f + 2]];
    const { alongU, isMirrored } = layoutOf(sections, corners);
    corners.forEach((v, k) => {
      const angle = cornerAngle(position, v, corners[(k + 1) % 3], corners[(k + 2) % 3]);
      perpendicular(alongU, rowOf(normal, 3, v)).forEach((x, i) => { sums[isMirrored ? 1 : 0][3 * v + i] += angle * x; });
    });
  }
  return sums.map((sum) => {
    for (let v = 0; v < vertices; ++v) {
      const tangent = rowOf(sum, 3, v);
      if (Math.hypot(...tangent) > 0) sum.set(unit(tangent), 3 * v);
    }
    return sum;
  });
}

/** A loaded file with what the shaders of its pixels read besides. */
export function withPixels(baked) {
  const { sections, atlases } = baked.transfer;
  if (!baked.runtime.shaders.pixels) return baked;
  const all = [];
  if (sections.albmap) all.push(['picture_place', 12, 2, sections.texture], ['tint', 13, 3, sections.tint]);
  if (atlases.length > 0) all.push(['place_in_atlas', 14, 3, placesInAtlases(baked.transfer)]);
  const attributes = all.map(([name, location, components, array]) => ({ name, location, components, array }));
  return withNormalMaps({ ...baked, attributes: [...baked.attributes, ...attributes] });
}

function withNormalMaps(baked) {
  const { vertices, sections } = baked.transfer;
  if (!sections.normmap) return baked;
  const [tangent, mirrored] = tangentsOf(baked.transfer);
  const places = new Float32Array(3 * vertices);
  sections.normmap.forEach((map, v) => places.set([sections.texture[2 * v], sections.texture[2 * v + 1], map], 3 * v));
  const attributes = [['texture_place', 9, places], ['tangent', 10, tangent], ['mirrored_tangent', 11, mirrored]];
  return { ...baked, textures: [...baked.textures, texture('normals', 'RGBA16F', sections.normtex)],
           attributes: [...baked.attributes, ...attributes.map(([name, location, array]) => ({ name, location, components: 3, array }))] };
}
