// The page: what it holds, the state, and a picture whenever something has changed.
import { FileError, numbersOf } from './transfer_file.js';
import { kernelsOf } from './kernels.js';
import { inDegree, load, Relighter, turned } from './relight.js';
import { capLight, extremes, lightOf, skyLight, sum, windowed } from './light.js';
import { axesOf, defaultOrbit, directionsToClip, eyeOf, minus, orbitOf, plus, rayThrough, toClip } from './camera.js';
import { fragmentOf, initialState, product, rotationOf, stateOf, turnAbout } from './state.js';
import { vertexAlong } from './pick.js';
import { boundsOf, DrawnMesh, Picture } from './picture.js';
import { Balls } from './ball.js';
import { buildPanel, showVertex } from './panel.js';
import { listen } from './input.js';

const kMeanings = {
  DU: 'transfer vector: its product with the light, times the albedo, is the radiance', DI: 'transfer vectors: their products with the light are the radiance',
  GS: 'visibility: 1 where the vertex sees the sky', GU: 'nothing: the light itself reaches the vertex',
};
kMeanings.DS = kMeanings.DU;
kMeanings.GI = kMeanings.GS;

const element = (id) => document.getElementById(id);

function tell(line) {
  element('message').textContent = line;
  element('message').hidden = line === '';
}

async function bytesOf({ name, data, url }) {
  if (url) {
    const answer = await fetch(url).catch(() => ({ ok: false }));
    if (!answer.ok) throw new FileError(`${name}: the server of this page does not answer: start \`prt view --serve\` again`);
    return new Uint8Array(await answer.arrayBuffer());
  }
  const text = atob(data);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  try {
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new FileError(`${name}: the page is damaged where it holds this file; write it again with \`prt view\``);
  }
}

// The color of what is not covered by the mesh: 0.3 after exposure, as `prt render` has it.
function greyOf(tone) {
  const linear = { neutral: 0.3 - 0.04, reinhard: 0.3 / 1.3, linear: 0.3 }[tone];
  return 1.055 * linear ** (1 / 2.4) - 0.055;
}

// Remembers the value that belongs to a key.
function remembered() {
  let last, value;
  return (key, make) => {
    if (key !== last) [last, value] = [key, make()];
    return value;
  };
}

class Viewer {
  constructor(data, canvas) {
    this.data = data;
    this.canvas = canvas;
    this.gl = canvas.getContext('webgl2', { antialias: true, alpha: false, powerPreference: 'high-performance' });
    if (!this.gl) throw new FileError('this browser has no WebGL 2, which the page needs: use a newer one, or switch graphics acceleration on');
    this.page = { degree: data.degree, skies: data.skies, fejer: data.fejer, kernels: kernelsOf(data.kernels) };
    this.given = lightOf(data.light);
    this.dropped = null;
    this.fileMeshes = [];
    this.source = remembered();
    this.cut = remembered();
    this.final = remembered();
    this.lit = new Map();  // file -> what it was relit with
  }

  async start() {
    for (const file of this.data.files) await this.addFile(file);
    this.bounds = this.fileMeshes[0].bounds;
    this.picture = new Picture(this.gl, this.data.shaders);
    this.balls = new Balls(this.gl, this.data.shaders, this.data.kernels);
    const first = initialState({ degree: this.data.degree, fileCount: this.data.files.length });
    const orbit = this.data.camera ? orbitOf(this.data.camera) : defaultOrbit(this.bounds, this.aspect);
    const kNarrow = 1.2;  // a camera of a scene sees less on a page that is higher than wide: it steps back
    if (this.data.camera) orbit.distance *= Math.max(1, kNarrow / this.aspect);
    this.begin = { ...first, ...orbit };
    this.state = this.valid(stateOf(location.hash.slice(1), this.begin));
    this.panel = buildPanel(element('controls'), {
      files: this.data.files, degree: this.data.degree, given: this.data.light.name,
      hasDropped: () => this.dropped?.name, isGlossy: () => this.fileMeshes.some(({ baked }) => baked.transfer.isGlossy),
      canMatch: () => this.areAlike(),
    }, (key, value) => this.set({ [key]: value }));
    element('name').textContent = this.fileMeshes[0].baked.transfer.scene;
    this.listen();
    this.panel.build(this.state);
    this.set({});
  }

  async addFile(file) {
    const bytes = await bytesOf(file);
    try {
      const baked = load(bytes, { shaders: file, kernels: this.data.kernels });
      const relighter = new Relighter(this.gl, baked);
      this.fileMeshes.push({ baked, relighter, mesh: new DrawnMesh(this.gl, relighter), bounds: boundsOf(baked.transfer), bytes: bytes.length, name: file.name });
    } catch (error) {
      throw error instanceof FileError ? new FileError(`${file.name}: ${error.message}`) : error;
    }
  }

  get aspect() { return this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight); }

  /** The state with what lies outside of its limits put right. */
  valid(state) {
    const clamp = (value, least, most) => Math.min(most, Math.max(least, value));
    const files = this.data.files.length;
    const out = { ...state };
    for (const key of ['a', 'b']) out[key] = clamp(Math.round(out[key]), 0, files - 1);
    out.degree = clamp(Math.round(out.degree), 0, this.data.degree);
    out.sky = clamp(Math.round(out.sky), 1, 16);
    out.elevation = clamp(out.elevation, 0, 90);
    out.halfAngle = clamp(out.halfAngle, 0.01, 180);
    out.pitch = clamp(out.pitch, -89.5, 89.5);
    out.stops = clamp(out.stops, -64, 64);
    out.wipe = clamp(out.wipe, 0, 1);
    if (!(out.distance > 0)) out.distance = this.begin.distance;
    out.fieldOfView = clamp(out.fieldOfView, 1, 170);
    if (Math.hypot(...out.turn) === 0) out.turn = [1, 0, 0, 0];
    if (!(out.vertex >= 0 && out.vertex < this.fileMeshes[out.a].baked.transfer.vertices)) out.vertex = -1;
    if (out.light === 'dropped' && !this.dropped) out.light = 'given';
    return out;
  }

  /** Changes entries of the state; a picture follows. */
  set(changes) {
    const lightChanges = changes.light !== undefined && changes.light !== this.state.light;
    this.state = this.valid({ ...this.state, ...changes });
    if (lightChanges) this.exposureIsKnown = false;
    this.panel.show(this.state);
    this.showTheme();
    clearTimeout(this.saving);
    this.saving = setTimeout(() => this.save(), 250);
    this.invalidate();
  }

  save() {
    const fragment = fragmentOf(this.state, this.begin);
    history.replaceState(null, '', fragment ? `#${fragment}` : location.pathname + location.search);
    this.showRinging();
  }

  invalidate() {
    this.pending ??= requestAnimationFrame(() => {
      this.pending = undefined;
      this.draw();
    });
  }

  /** The light before its window: what the controls choose, in the degree of the page. */
  sourceLight() {
    const { light, sky, elevation, azimuth, sun, halfAngle, irradiance } = this.state;
    return this.source(JSON.stringify([light, sky, elevation, azimuth, sun, halfAngle, irradiance, this.dropped?.name]), () => {
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
  windowedLight() {
    const { degree, window: type, strength } = this.state;
    const source = this.sourceLight();
    return this.cut(JSON.stringify([degree, type, strength, this.sourceKey(source)]), () => windowed(this.page, inDegree(source, degree), type, strength));
  }

  sourceKey(source) {
    this.keys ??= new WeakMap();
    if (!this.keys.has(source)) this.keys.set(source, (this.lastKey = (this.lastKey ?? 0) + 1));
    return this.keys.get(source);
  }

  /** The light that shines, in the degree of the page. */
  light() {
    const { light } = this.windowedLight();
    return this.final(JSON.stringify([this.state.turn, this.sourceKey(light)]), () => (
      turned(this.page.kernels, inDegree(light, this.page.degree), rotationOf(this.state.turn))));
  }

  relight(index) {
    const { relighter, baked } = this.fileMeshes[index];
    const { isGlossy, frame } = baked.transfer;
    const { ownSurface, exponent, specular } = this.state;
    const light = this.light();
    const eye = minus(eyeOf(this.state), frame.origin).map((x) => x / frame.unit);
    const key = JSON.stringify([this.sourceKey(light), isGlossy && [eye, ownSurface, exponent, specular]]);
    if (this.lit.get(index) === key) return;
    relighter.relight(light, { eye, surface: isGlossy && ownSurface ? { exponent, specular: [specular, specular, specular] } : null });
    this.lit.set(index, key);
    this.reference = undefined;
  }

  /** Whether both files show one mesh, vertex by vertex. */
  areAlike() {
    const [a, b] = [this.state.a, this.state.b].map((index) => this.fileMeshes[index].baked.transfer.sections);
    this.alike ??= new Map();
    const key = `${this.state.a} ${this.state.b}`;
    const same = (x, y) => x.length === y.length && x.every((value, i) => value === y[i]);
    if (!this.alike.has(key)) this.alike.set(key, same(a.position, b.position) && same(a.face, b.face));
    return this.alike.get(key);
  }

  draw() {
    const began = performance.now();
    const { gl, state } = this;
    const scale = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [Math.max(1, Math.round(this.canvas.clientWidth * scale)), Math.max(1, Math.round(this.canvas.clientHeight * scale))];
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
    try {
      this.relight(state.a);
      if (state.compare !== 'none') this.relight(state.b);
      tell('');
    } catch (error) {
      if (!(error instanceof FileError)) throw error;
      tell(`${this.fileMeshes[state.a].name}: ${error.message}`);
    }
    this.measure();
    gl.viewport(0, 0, width, height);
    const grey = greyOf(state.tone);
    gl.clearColor(grey, grey, grey, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const look = { exposure: this.exposure, tone: state.tone };
    if (state.background === 'light') this.balls.draw(this.light(), { ...look, toClip: directionsToClip(state, this.aspect), depth: false });
    this.drawMeshes(width, height, look);
    if (state.balls) this.drawBalls(scale, look);
    this.showTime(began);
    this.showPlaces();
  }

  get exposure() { return (this.state.exposure || this.measured) * 2 ** this.state.stops; }

  // The exposure stays until the kind of light changes or the user asks: the picture does not flicker.
  measure() {
    if (this.exposureIsKnown || this.state.exposure > 0) return;
    this.exposureIsKnown = true;
    this.measured = this.picture.measure(this.fileMeshes[this.state.a].mesh, this.clipOf(this.state.a, 16 / 9));
  }

  clipOf(index, aspect = this.aspect) {
    const { bounds, baked } = this.fileMeshes[index];
    return toClip(this.state, aspect, bounds, baked.transfer.frame);
  }

  drawMeshes(width, height, look) {
    const { gl, state } = this;
    const { mesh, relighter } = this.fileMeshes[state.a];
    const showsDifference = state.compare === 'difference' && this.areAlike();
    if (showsDifference) {
      mesh.compareWith(this.fileMeshes[state.b].relighter);
      this.reference ??= Math.sqrt(relighter.read().reduce((total, value, _, all) => total + (value * value) / all.length, 0)) || 1;
    }
    const middle = state.compare === 'wipe' ? Math.round(state.wipe * width) : width;
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, 0, middle, height);
    this.picture.draw(mesh, { ...look, toClip: this.clipOf(state.a), mode: showsDifference ? 1 : 0, reference: this.reference });
    if (state.compare === 'wipe') {
      gl.scissor(middle, 0, width - middle, height);
      this.picture.draw(this.fileMeshes[state.b].mesh, { ...look, toClip: this.clipOf(state.b) });
    }
    gl.disable(gl.SCISSOR_TEST);
  }

  // The light as seen from outside, and the transfer of the vertex, both turned as the camera sees them.
  drawBalls(scale, look) {
    const { gl } = this;
    const isNarrow = window.innerWidth <= 720;  // as style.css has it
    const size = (isNarrow ? 88 : 128) * scale;
    const { right, up, back } = axesOf(this.state);
    const toBall = [0, 1, 2].flatMap((k) => [0.95 * right[k], 0.95 * up[k], -0.5 * back[k], 0]).concat(0, 0, 0, 1);
    const draw = (column, light, more) => {
      const [x, y] = [(12 + column * (size / scale + 12)) * scale, (isNarrow ? 22 : 50) * scale];
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(x, y, size, size);
      gl.clear(gl.DEPTH_BUFFER_BIT);
      gl.disable(gl.SCISSOR_TEST);
      gl.viewport(x, y, size, size);
      this.balls.draw(light, { ...look, ...more, toClip: toBall });
    };
    draw(0, this.light(), {});
    const transfer = this.lobe();
    if (transfer) draw(1, transfer.light, { lobe: 1 / transfer.most, accent: this.accent() });
  }

  accent() {
    const hex = getComputedStyle(document.documentElement).getPropertyValue('--accent').trim();
    return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);
  }

  // The transfer of the chosen vertex as a function on the sphere: {light, most}, most its largest absolute value.
  lobe() {
    const { vertex, a } = this.state;
    const { transfer } = this.fileMeshes[a].baked;
    if (vertex < 0 || transfer.shape.count === 0) return null;
    this.lobes ??= remembered();
    return this.lobes(`${a} ${vertex}`, () => {
      const numbers = numbersOf(transfer, vertex);
      const degree = Math.sqrt(transfer.shape.columns) - 1;
      const values = transfer.shape.channels === 3 ? numbers : Float64Array.from([...numbers, ...numbers, ...numbers]);
      const { least, largest } = this.extremesOf({ degree, values });
      return { light: { degree, values }, most: Math.max(-least, largest, 1e-30) };
    });
  }

  extremesOf(light) {
    const evaluate = this.page.kernels[`evaluate_rgb_l${light.degree}`];
    let least = Infinity, largest = -Infinity;
    for (let k = 0, rgb = [0, 0, 0]; k < 2000; ++k) {
      const z = 1 - (2 * k + 1) / 2000, angle = k * Math.PI * (3 - Math.sqrt(5)), r = Math.sqrt(1 - z * z);
      evaluate(light.values, r * Math.cos(angle), r * Math.sin(angle), z, rgb);
      [least, largest] = [Math.min(least, rgb[1]), Math.max(largest, rgb[1])];
    }
    return { least, largest };
  }

  // What of the light's sphere is negative, and what a window changes. Waits until the user rests.
  showRinging() {
    const note = element('ringing');
    if (!note) return;
    const source = inDegree(this.sourceLight(), this.state.degree);
    const { light, strength } = this.windowedLight();
    const before = extremes(this.page, source);
    const after = this.state.window === 'none' ? before : extremes(this.page, light);
    const part = (value) => `${(100 * (before.largest > 0 ? value / before.largest : 0)).toFixed(1)} %`;
    note.textContent = this.state.window === 'none'
      ? `Least radiance ${part(before.least)} of the peak.`
      : `Least radiance ${part(after.least)} of the peak, ${part(before.least)} without; keeps ${part(after.largest)} of the peak` +
        `${this.state.window === 'auto' ? `; strength ${strength.toFixed(3)}` : ''}.`;
  }

  showTime(began) {
    const { gl } = this;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const look = () => {
      const status = gl.clientWaitSync(fence, 0, 0);
      if (status === gl.TIMEOUT_EXPIRED) return setTimeout(look, 1);
      gl.deleteSync(fence);
      element('time').textContent = `${(performance.now() - began).toFixed(1)} ms`;
      return undefined;
    };
    setTimeout(look, 0);
    const { baked, bytes } = this.fileMeshes[this.state.a];
    const { kind, shape, vertices } = baked.transfer;
    const stored = shape.count === 0 ? '' : `, ${shape.clusters ? `${shape.clusters} clusters` : shape.element}`;
    element('facts').textContent = `${kind}, degree ${shape.degree}${stored} · ${vertices.toLocaleString('en')} vertices · ${(bytes / 2 ** 20).toFixed(2)} MiB`;
  }

  // What lies over the picture: the divider, the marker of the vertex, the scale, labels.
  showPlaces() {
    const { state, canvas } = this;
    element('divider').hidden = state.compare !== 'wipe';
    element('divider').style.left = `${100 * state.wipe}%`;
    element('left').textContent = this.data.files[state.a].name;
    element('right').textContent = this.data.files[state.b].name;
    element('scale').hidden = !(state.compare === 'difference' && this.areAlike());
    element('balls').hidden = !state.balls;
    element('ball-lobe').hidden = !this.lobe();
    const marker = element('marker');
    marker.hidden = state.vertex < 0;
    if (state.vertex < 0) return;
    const { transfer } = this.fileMeshes[state.a].baked;
    const p = [...transfer.sections.position.subarray(3 * state.vertex, 3 * state.vertex + 3), 1];
    const m = this.clipOf(state.a);
    const [x, y, , w] = [0, 1, 2, 3].map((row) => p.reduce((total, value, k) => total + m[row + 4 * k] * value, 0));
    marker.style.left = `${((x / w + 1) / 2) * canvas.clientWidth}px`;
    marker.style.top = `${((1 - y / w) / 2) * canvas.clientHeight}px`;
    this.showNumbers(transfer);
  }

  showNumbers(transfer) {
    const { vertex, a } = this.state;
    const { origin, unit } = transfer.frame;
    const three = (name) => transfer.sections[name].subarray(3 * vertex, 3 * vertex + 3);
    showVertex(element('vertex'), {
      vertex, position: [...three('position')].map((x, k) => origin[k] + unit * x), normal: three('normal'),
      radiance: this.fileMeshes[a].relighter.read(vertex, 1), numbers: numbersOf(transfer, vertex), shape: transfer.shape, meaning: kMeanings[transfer.kind],
    });
  }

  showTheme() {
    const { theme } = this.state;
    const dark = theme === 'dark' || (theme === 'system' && matchMedia('(prefers-color-scheme: dark)').matches);
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  }

  pick(x, y) {
    const { baked } = this.fileMeshes[this.state.a];
    const { origin, unit } = baked.transfer.frame;
    const ray = rayThrough(this.state, this.aspect, (2 * x) / this.canvas.clientWidth - 1, 1 - (2 * y) / this.canvas.clientHeight);
    this.set({ vertex: vertexAlong(baked.transfer, minus(eyeOf(this.state), origin).map((value) => value / unit), ray) });
    if (this.state.vertex < 0) element('vertex').innerHTML = '<p class="note">Click the mesh.</p>';
  }

  async drop(file) {
    try {
      if (!/\.json$/i.test(file.name)) throw new FileError('expected coefficients: the JSON that `prt project PICTURE --degree N` prints, for pictures too');
      let json;
      try {
        json = JSON.parse(await file.text());
      } catch (error) {
        throw new FileError(`not JSON: ${error.message}`);
      }
      this.dropped = { name: file.name, light: lightOf(json) };
      this.panel.build(this.state);
      this.exposureIsKnown = false;
      this.set({ light: 'dropped' });
    } catch (error) {
      if (!(error instanceof FileError)) throw error;
      tell(`${file.name}: ${error.message}`);
    }
  }

  key(key) {
    const { state } = this;
    const compares = this.data.files.length > 1 ? ['none', 'wipe', 'difference'] : ['none'];
    const actions = {
      '[': () => ({ stops: state.stops - 0.5 }), ']': () => ({ stops: state.stops + 0.5 }),
      ',': () => ({ degree: state.degree - 1 }), '.': () => ({ degree: state.degree + 1 }),
      e: () => { this.exposureIsKnown = false; return { exposure: 0 }; },
      c: () => ({ compare: compares[(compares.indexOf(state.compare) + 1) % compares.length] }),
      t: () => ({ theme: document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark' }),
      z: () => { this.exposureIsKnown = false; return this.begin; },
      p: () => { element('side').classList.toggle('folded'); return {}; },
    };
    if (Object.hasOwn(actions, key)) this.set(actions[key]());
  }

  listen() {
    listen(this.canvas, {
      orbit: (dx, dy) => this.set({ yaw: this.state.yaw - dx, pitch: this.state.pitch + dy }),
      turn: (dx, dy) => {
        const about = product(turnAbout(axesOf(this.state).right, dy), turnAbout([0, 0, 1], dx));
        this.set({ turn: product(about, this.state.turn) });
      },
      zoom: (factor) => this.set({ distance: this.state.distance * factor }),
      move: (dx, dy) => {
        const { right, up } = axesOf(this.state);
        const pixel = (2 * this.state.distance * Math.tan((this.state.fieldOfView * Math.PI) / 360)) / this.canvas.clientHeight;
        this.set({ target: plus(plus(this.state.target, right, -dx * pixel), up, dy * pixel) });
      },
      pick: (x, y) => this.pick(x, y),
      key: (key) => this.key(key),
      drop: (file) => this.drop(file),
    });
    element('theme').addEventListener('click', () => this.key('t'));
    element('fold').addEventListener('click', () => this.key('p'));
    element('divider').addEventListener('pointerdown', (event) => event.target.setPointerCapture(event.pointerId));
    element('divider').addEventListener('pointermove', (event) => {
      if (event.buttons & 1) this.set({ wipe: (event.clientX - this.canvas.getBoundingClientRect().left) / this.canvas.clientWidth });
    });
    new ResizeObserver(() => this.invalidate()).observe(this.canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.set({}));
    window.addEventListener('hashchange', () => this.set(stateOf(location.hash.slice(1), this.begin)));
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      tell('the GPU was taken away from this page: load it again');
    });
  }
}

async function open() {
  try {
    const viewer = new Viewer(JSON.parse(element('data').textContent), element('view'));
    await viewer.start();
    globalThis.viewer = viewer;  // for scripts
  } catch (error) {
    tell(error.message);
    if (!(error instanceof FileError)) throw error;
  } finally {
    document.documentElement.dataset.ready = 'true';
  }
}

open();
