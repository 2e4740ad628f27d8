// The light that the controls choose: from its source over degree and window to its turn. Each step is computed again only
// if what it depends on has changed.
import { inDegree, turned } from './relight.js';
import { capLight, extremes, lightOf, skyLight, sum, windowed } from './light.js';
import { kernelsOf } from './kernels.js';
import { rotationOf } from './state.js';

/** Remembers the value that belongs to a key. */
export function remembered() {
  let last, value;
  return (key, make) => {
    if (key !== last) [last, value] = [key, make()];
    return value;
  };
}

export class Lighting {
  constructor({ degree, skies, fejer, kernels, light }) {
    this.page = { degree, skies, fejer, kernels: kernelsOf(kernels) };
    this.given = lightOf(light);
    this.dropped = null;  // {name, light} of a file that was dropped on the page
    [this.source, this.cut, this.final] = [remembered(), remembered(), remembered()];
    this.keys = new WeakMap();
  }

  /** A number that no other light has. */
  keyOf(light) {
    if (!this.keys.has(light)) this.keys.set(light, (this.lastKey = (this.lastKey ?? 0) + 1));
    return this.keys.get(light);
  }

  /** Before its window: in the degree of the page. */
  sourceOf(state) {
    const { light, sky, elevation, azimuth, sun, halfAngle, irradiance } = state;
    return this.source(JSON.stringify([light, sky, elevation, azimuth, sun, halfAngle, irradiance, this.dropped && this.keyOf(this.dropped)]), () => {
      if (light === 'sky') {
        const type = { type: sky, elevation: sky === 16 ? 90 : elevation, azimuth: sky === 16 ? 0 : azimuth };
        const disc = { elevation, azimuth, halfAngle: 0.2666, irradiance: sky === 16 ? 0 : sun };
        return sum(skyLight(this.page, type), capLight(this.page, disc));
      }
      if (light === 'cap') return capLight(this.page, { elevation, azimuth, halfAngle, irradiance });
      return inDegree(light === 'dropped' ? this.dropped.light : this.given, this.page.degree);
    });
  }

  /** Under its window, before its turn: {light, strength}, in the degree of the slider. */
  windowedOf(state) {
    const { degree, window: type, strength } = state;
    const source = this.sourceOf(state);
    return this.cut(JSON.stringify([degree, type, strength, this.keyOf(source)]), () => windowed(this.page, inDegree(source, degree), type, strength));
  }

  /** The light that shines, in the degree of the page. */
  of(state) {
    const { light } = this.windowedOf(state);
    return this.final(JSON.stringify([state.turn, this.keyOf(light)]), () => (
      turned(this.page.kernels, inDegree(light, this.page.degree), rotationOf(state.turn))));
  }

  /** What of the light's sphere is negative, and what a window changes. */
  ringingOf(state) {
    const { light, strength } = this.windowedOf(state);
    const before = extremes(this.page, inDegree(this.sourceOf(state), state.degree));
    const after = state.window === 'none' ? before : extremes(this.page, light);
    const part = (value) => `${(100 * (before.largest > 0 ? value / before.largest : 0)).toFixed(1)} %`;
    if (state.window === 'none') return `Least radiance ${part(before.least)} of the peak.`;
    return `Least radiance ${part(after.least)} of the peak, ${part(before.least)} without; keeps ${part(after.largest)} of the peak` +
      `${state.window === 'auto' ? `; strength ${strength.toFixed(3)}` : ''}.`;
  }
}
