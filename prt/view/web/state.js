// What the user sees, as plain values, and the URL's fragment that restores it. Only what differs from the start is written.

/** The state of a page without a fragment. */
export function initialState({ degree, subjectCount }) {
  return {
    a: 0, b: subjectCount > 1 ? 1 : 0, compare: 'none', wipe: 0.5, time: 0, playing: false,
    light: 'given', sky: 12, elevation: 40, azimuth: -120, sun: 2, halfAngle: 10, irradiance: 3, turn: [1, 0, 0, 0],
    degree, window: 'none', strength: 0.5,
    stops: 0, exposure: 0, tone: 'neutral', background: 'grey',
    ownSurface: false, exponent: 20, specular: 0.5,
    yaw: 0, pitch: 0, distance: 0, target: [0, 0, 0], fieldOfView: 40,
    vertex: -1, theme: 'system', balls: true,
  };
}

const kPlaces = 6;

const rounded = (value) => (typeof value === 'number' ? Number(value.toPrecision(kPlaces)) : value);

/** state -> the text after #; `start` is the state without a fragment. */
export function fragmentOf(state, start) {
  const parts = new URLSearchParams();
  for (const [key, value] of Object.entries(state)) {
    const text = Array.isArray(value) ? value.map(rounded).join(',') : String(rounded(value));
    const before = Array.isArray(start[key]) ? start[key].map(rounded).join(',') : String(rounded(start[key]));
    if (text !== before) parts.set(key, text);
  }
  return parts.toString().replace(/%2C/g, ',');
}

function parsed(text, like) {
  if (typeof like === 'number') return Number.isFinite(Number(text)) && text !== '' ? Number(text) : like;
  if (typeof like === 'boolean') return text === 'true';
  if (!Array.isArray(like)) return text;
  const values = text.split(',').map(Number);
  return values.length === like.length && values.every(Number.isFinite) ? values : like;
}

/** The state of a fragment; entries that are unknown or no values of their kind are left out. */
export function stateOf(fragment, start) {
  const state = { ...start };
  for (const [key, text] of new URLSearchParams(fragment)) if (key in start) state[key] = parsed(text, start[key]);
  return state;
}

const clamp = (value, least, most) => Math.min(most, Math.max(least, value));

/** The state with what lies outside of its limits put right; vertices: how many each subject has. */
export function validState(state, { begin, degree, hasDropped, vertices }) {
  const out = { ...state };
  for (const key of ['a', 'b']) out[key] = clamp(Math.round(out[key]), 0, vertices.length - 1);
  out.degree = clamp(Math.round(out.degree), 0, degree);
  out.time = clamp(out.time, 0, 1);
  out.sky = clamp(Math.round(out.sky), 1, 16);
  out.elevation = clamp(out.elevation, 0, 90);
  out.halfAngle = clamp(out.halfAngle, 0.01, 180);
  out.pitch = clamp(out.pitch, -89.5, 89.5);
  out.stops = clamp(out.stops, -64, 64);
  out.wipe = clamp(out.wipe, 0, 1);
  if (!(out.distance > 0)) out.distance = begin.distance;
  out.fieldOfView = clamp(out.fieldOfView, 1, 170);
  if (Math.hypot(...out.turn) === 0) out.turn = [1, 0, 0, 0];
  if (!(out.vertex >= 0 && out.vertex < vertices[out.a])) out.vertex = -1;
  if (out.light === 'dropped' && !hasDropped) out.light = 'given';
  return out;
}

/** Rotation of a unit quaternion (w, x, y, z), 9 numbers row by row. */
export function rotationOf([w, x, y, z]) {
  const s = 2 / (w * w + x * x + y * y + z * z);
  return [1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),
          s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x),
          s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)];
}

/** The quaternion of first b, then a. */
export function product([w, x, y, z], [v, i, j, k]) {
  const q = [w * v - x * i - y * j - z * k, w * i + x * v + y * k - z * j, w * j - x * k + y * v + z * i, w * k + x * j - y * i + z * v];
  const size = Math.hypot(...q);
  return q.map((value) => value / size);
}

/** The quaternion of a turn about a unit axis, right-handed. */
export function turnAbout(axis, degrees) {
  const half = (degrees * Math.PI) / 360;
  return [Math.cos(half), ...axis.map((x) => x * Math.sin(half))];
}
