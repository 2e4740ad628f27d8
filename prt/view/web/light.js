// The lights of the page, made from the generated functions: skies, caps, coefficients from a file; windows and ringing.
// Conventions as in prt/light: z up, azimuth from +x towards +y, angles in degrees.
import { darkness, inDegree, turned } from './relight.js';
import { FileError } from './transfer_file.js';
import { gaussLegendre, inRadians, remembering, rotationAbout } from './vectors.js';

/** The unit vector towards an elevation and an azimuth. */
export function towards(elevation, azimuth) {
  const [e, a] = [inRadians(elevation), inRadians(azimuth)];
  return [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
}

// Nodes and weights on [0, 1] [TakahasiMori74], for what changes quickly near the ends.
function tanhSinh(side) {
  const step = 3.2 / side;
  return Array.from({ length: 2 * side + 1 }, (_, k) => {
    const s = 0.5 * Math.PI * Math.sinh((k - side) * step);
    return [0.5 * (1 + Math.tanh(s)), (0.25 * Math.PI * step * Math.cosh((k - side) * step)) / Math.cosh(s) ** 2];
  });
}

const kAlong = gaussLegendre(40);
const kAcross = tanhSinh(32);

// The coefficients, one channel, of a sky above the horizon that is even about the meridian of its sun, over +x: arcs from
// the sun to the horizon, as prt/light/sky.cpp. radiance(chi, z): at the angle chi from the sun and the height z.
function projectSky(basis, degree, elevation, radiance) {
  const sum = new Float64Array((degree + 1) ** 2), values = new Float64Array(sum.length);
  const [c, s] = [Math.cos(inRadians(elevation)), Math.sin(inRadians(elevation))];
  for (const [part, across] of kAcross) {
    for (const bearing of [0.5 * Math.PI * part, Math.PI - 0.5 * Math.PI * part]) {
      const side = [-s * Math.cos(bearing), Math.sin(bearing), c * Math.cos(bearing)];
      const length = Math.atan2(s, -side[2]);
      for (const [node, along] of kAlong) {
        const chi = 0.5 * length * (1 + node);
        const [x, y, z] = [Math.cos(chi) * c + Math.sin(chi) * side[0], Math.sin(chi) * side[1], Math.cos(chi) * s + Math.sin(chi) * side[2]];
        if (z <= 0) continue;
        basis(x, y, z, values);
        const weight = 0.5 * Math.PI * length * across * along * Math.sin(chi) * radiance(chi, z);
        values.forEach((value, i) => { sum[i] += weight * value; });
      }
    }
  }
  for (let l = 1; l <= degree; ++l) sum.fill(0, l * l, l * l + l);  // orders below 0: the sky is even
  return sum;
}

// The CIE general skies of 1 at the zenith [CIE03, equations 1 to 5]; 16 is the traditional overcast sky.
function skyRadiance(skies, type, elevation) {
  if (type === 16) return (chi, z) => (1 + 2 * z) / 3;
  const [a, b, c, d, e] = skies[type - 1];
  const gradation = (z) => 1 + a * Math.exp(b / z);
  const indicatrix = (chi) => 1 + c * (Math.exp(d * chi) - Math.exp((d * Math.PI) / 2)) + e * Math.cos(chi) ** 2;
  const zenith = indicatrix(Math.PI / 2 - inRadians(elevation)) * gradation(1);
  return (chi, z) => (indicatrix(chi) * gradation(z)) / zenith;
}

/** A light that is white: one channel for all. */
function white(degree, channel) {
  const light = darkness(degree);
  for (let c = 0; c < 3; ++c) light.values.set(channel, c * channel.length);
  return light;
}

/** The sky `type` (1 to 16) of radiance 1 at the zenith. */
export function skyLight({ kernels, degree, skies }, { type, elevation, azimuth }) {
  const channel = projectSky(kernels[`basis_l${degree}`], degree, elevation, skyRadiance(skies, type, elevation));
  return turned(kernels, white(degree, channel), rotationAbout([0, 0, 1], azimuth));
}

/** A disc at infinity of this half-angle that gives a surface which faces it this irradiance, W m^-2; color: linear RGB. */
export function capLight({ kernels, degree }, { elevation, azimuth, halfAngle, irradiance, color = [1, 1, 1] }) {
  const light = darkness(degree);
  const oneMinusCos = 2 * Math.sin(inRadians(halfAngle) / 2) ** 2;
  const radiance = irradiance / (Math.PI * Math.sin(Math.min(inRadians(halfAngle), Math.PI / 2)) ** 2);
  kernels[`add_cap_rgb_l${degree}`](...towards(elevation, azimuth), oneMinusCos, ...color.map((part) => part * radiance), light.values);
  return light;
}

export function sum(a, b) { return { degree: a.degree, values: a.values.map((value, i) => value + b.values[i]) }; }

/** The light of JSON as `prt project` prints it. Throws FileError. */
export function lightOf(json) {
  const { degree, coefficients } = json ?? {};
  const n = (degree + 1) ** 2;
  const fits = Number.isInteger(degree) && degree >= 0 && degree <= 10 && Array.isArray(coefficients) && coefficients.length === 3 &&
    coefficients.every((channel) => Array.isArray(channel) && channel.length === n && channel.every(Number.isFinite));
  if (!fits) throw new FileError('not a light: expected the JSON of `prt project LIGHT --degree N`, three channels of (N+1)^2 coefficients');
  return { degree, values: Float64Array.from(coefficients.flat()) };
}

export const kWindows = ['none', 'auto', 'fejer', 'hann', 'lanczos', 'laplacian', 'gaussian'];

// What a window of a strength from 0 to 1 multiplies each band with; as window_of_strength and window_factors of
// prt/light/window.hpp. At strength 0 nothing, at 1 only band 0 is left (fejer: its kernel).
function windowFactors({ kernels, degree: highest, fejer }, type, strength, degree) {
  const ones = new Array(degree + 1).fill(1);
  if (type === 'none' || strength <= 0 || degree === 0) return ones;
  if (type === 'fejer' || type === 'auto') return fejer[degree].map((factor) => 1 - strength * (1 - factor));
  if (strength >= 1) return ones.map((_, l) => (l === 0 ? 1 : 0));
  const odds = strength / (1 - strength), width = 1 / strength, x = Math.PI / width;
  const c = new Float64Array((highest + 1) ** 2).fill(1);
  const run = (name, ...numbers) => kernels[`window_${name}_l${highest}`](...numbers, c);
  if (type === 'hann') run('hann', Math.cos(x));
  if (type === 'lanczos') run('lanczos', Math.cos(x), Math.sin(x) / x);
  if (type === 'laplacian') run('laplacian', odds ** 4);
  if (type === 'gaussian') run('gaussian', Math.exp(-0.5 * odds * odds));
  const isCutOff = type === 'hann' || type === 'lanczos';
  return ones.map((_, l) => (isCutOff && l >= width ? 0 : c[l * l]));
}

const kBases = new WeakMap();  // of points that come again

// The basis in a direction, of the page's degree.
function basisAt({ kernels, degree }, point) {
  if (!kBases.has(point)) {
    const values = new Float64Array((degree + 1) ** 2);
    kernels[`basis_l${degree}`](...point, values);
    kBases.set(point, values);
  }
  return kBases.get(point);
}

// The value of each band of a light where the basis has these values, channel by channel: (3, degree + 1).
function bandValues(basis, { degree, values }) {
  const n = (degree + 1) ** 2;
  const out = new Float64Array(3 * (degree + 1));
  for (let c = 0; c < 3; ++c) {
    for (let l = 0; l <= degree; ++l) {
      for (let i = l * l; i < (l + 1) ** 2; ++i) out[c * (degree + 1) + l] += basis[i] * values[c * n + i];
    }
  }
  return out;
}

// The largest value of a function on the sphere: the best point of a spiral of 64 bands^2 points, then smaller and smaller
// steps around it.
function largest(points, value) {
  let best = -Infinity, at = points[0];
  const offer = (point) => {
    const here = value(point);
    if (here > best) [best, at] = [here, point];
    return best === here;
  };
  points.forEach(offer);
  for (let step = 4 / Math.sqrt(points.length); step > 1e-5; step /= 2) {
    for (let moved = true, left = 8; moved && left > 0; --left) {
      moved = false;
      for (const axis of [0, 1, 2]) {
        for (const sign of [-1, 1]) {
          const next = at.map((x, k) => x + (k === axis ? sign * step : 0));
          const size = Math.hypot(...next);
          const before = at;
          offer(next.map((x) => x / size));
          moved = moved || at !== before;
        }
      }
    }
  }
  return best;
}

/** 64 bands^2 points that lie evenly on the sphere. */
export const spiralOf = remembering((degree) => {
  const count = 64 * (degree + 1) ** 2;
  return Array.from({ length: count }, (_, k) => {
    const z = 1 - (2 * k + 1) / count, angle = k * Math.PI * (3 - Math.sqrt(5)), r = Math.sqrt(1 - z * z);
    return [r * Math.cos(angle), r * Math.sin(angle), z];
  });
});

const dot = (factors, bands, c) => factors.reduce((sum, factor, l) => sum + factor * bands[c * factors.length + l], 0);

// For each point the value of each band, computed once.
function bandsOf(page, light) {
  const cache = new Map();
  return (point) => {
    if (!cache.has(point)) cache.set(point, bandValues(basisAt(page, point), light));
    return cache.get(point);
  };
}

const kChannels = [0, 1, 2];

/**
 * The light under a window: {light, strength}. The automatic window is the least `fejer` that leaves no negative radiance
 * [Sloan17].
 */
export function windowed(page, light, type, strength) {
  const degree = light.degree;
  if (type === 'auto') {
    // Values are linear in the strength: wanted is the one at which the lowest of them is zero.
    const bandsAt = bandsOf(page, light);
    const none = new Array(degree + 1).fill(1);
    const full = windowFactors(page, 'fejer', 1, degree);
    strength = Math.min(1, Math.max(0, largest(spiralOf(degree), (point) => Math.max(...kChannels.map((c) => {
      const now = dot(none, bandsAt(point), c), then = dot(full, bandsAt(point), c);
      return now < 0 && then > now ? now / (now - then) : 0;
    })))));
  }
  const factors = windowFactors(page, type, strength, degree);
  const out = inDegree(light, degree);
  const n = (degree + 1) ** 2;
  out.values.forEach((_, i) => { out.values[i] *= factors[Math.floor(Math.sqrt(i % n))]; });
  return { light: out, strength };
}

/** The least radiance of any channel and the largest; of the band-limited light, turned or not. */
export function extremes(page, light) {
  const bandsAt = bandsOf(page, light);
  const all = new Array(light.degree + 1).fill(1);
  const of = (sign) => largest(spiralOf(light.degree), (point) => Math.max(...kChannels.map((c) => sign * dot(all, bandsAt(point), c))));
  return { least: -of(-1), largest: of(1) };
}

// The basis at azimuth 0, integrated over sin(theta) d(theta); the polar factors of the orders from 0 on.
function polarIntegrals(basis, degree, from, to) {
  const sum = new Float64Array((degree + 1) ** 2), values = new Float64Array(sum.length);
  for (const [node, weight] of kAlong) {
    const theta = 0.5 * (from + to) + 0.5 * (to - from) * node;
    basis(Math.sin(theta), 0, Math.cos(theta), values);
    values.forEach((value, i) => { sum[i] += 0.5 * (to - from) * weight * Math.sin(theta) * value; });
  }
  return sum;
}

/**
 * The light of a lat-long picture (prt/IMAGES.md): each pixel is a patch of constant radiance, over which the basis is
 * integrated, as prt/light/project_image.cpp does.
 */
export function lightOfPicture({ kernels, degree }, { width, height, pixels }) {
  if (width !== 2 * height) throw new FileError(`the picture is ${width} x ${height} pixels; a lat-long environment is twice as wide as high`);
  const light = darkness(degree);
  const step = (2 * Math.PI) / width, n = (degree + 1) ** 2;
  const waves = Array.from({ length: 2 * degree + 1 }, (_, k) => {
    const m = k - degree, order = Math.abs(m);
    const extent = m === 0 ? step : (2 * Math.sin(0.5 * order * step)) / order;
    return Float64Array.from({ length: width }, (_column, i) => {
      const phi = Math.PI * (1 - (2 * i + 1) / width);  // the pixel's center
      return extent * (m < 0 ? Math.sin(order * phi) : Math.cos(order * phi));
    });
  });
  for (let row = 0; row < height; ++row) {
    const polar = polarIntegrals(kernels[`basis_l${degree}`], degree, (row * Math.PI) / height, ((row + 1) * Math.PI) / height);
    waves.forEach((wave, k) => {
      const m = k - degree;
      for (const c of kChannels) {
        let sum = 0;
        for (let i = 0; i < width; ++i) sum += wave[i] * pixels[3 * (row * width + i) + c];
        for (let l = Math.abs(m); l <= degree; ++l) light.values[c * n + l * (l + 1) + m] += polar[l * (l + 1) + Math.abs(m)] * sum;
      }
    });
  }
  return light;
}
