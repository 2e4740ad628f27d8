// The page: what it holds, the state, and a picture whenever something has changed.
import { FileError } from './transfer_file.js';
import { axesOf, defaultOrbit, directionsToClip, orbitOf, rayThrough } from './camera.js';
import { fragmentOf, initialState, product, stateOf, turnAbout, validState } from './state.js';
import { bytesOf } from './embedded.js';
import { plus } from './vectors.js';
import { greyOf, Picture } from './picture.js';
import { Balls } from './ball.js';
import { fileOf, Subject } from './subject.js';
import { Medium } from './medium.js';
import { withPictures } from './surfaces.js';
import { Lighting } from './lighting.js';
import { lightOfFile } from './light_file.js';
import { accentColor, element, lobeOf, showChosen, showComparison, showTheme, showTime, tell } from './overlay.js';
import { buildPanel } from './panel.js';
import { listen } from './input.js';

class Viewer {
  constructor(data, canvas) {
    this.data = data;
    this.canvas = canvas;
    this.gl = canvas.getContext('webgl2', { antialias: true, alpha: false, powerPreference: 'high-performance' });
    if (!this.gl) throw new FileError('this browser has no WebGL 2, which the page needs: use a newer one, or switch graphics acceleration on');
    this.lighting = new Lighting(data);
    this.lit = new Map();  // subject -> what it was relit with
  }

  async start() {
    const { data, gl } = this;
    const files = [];
    for (const given of data.files) {
      const file = fileOf(given, await bytesOf(given), data.kernels);
      files.push(file.volume ? file : await withPictures(file));
    }
    this.subjects = data.subjects.map((subject, number) => {
      const file = files[subject.objects[0].file];
      return file.baked.transfer.grid ? new Medium(gl, subject, file, number, data.kernels) : new Subject(gl, subject, files, number);
    });
    this.picture = new Picture(gl, data.shaders);
    this.balls = new Balls(gl, data.shaders, data.kernels);
    const orbit = data.camera ? orbitOf(data.camera) : defaultOrbit(this.subjects[0].bounds, this.aspect);
    const kNarrow = 1.2;  // a camera of a scene sees less on a page that is higher than wide: it steps back
    if (data.camera) orbit.distance *= Math.max(1, kNarrow / this.aspect);
    this.begin = { ...initialState({ degree: data.degree, subjectCount: this.subjects.length }), ...orbit };
    this.state = this.valid(stateOf(location.hash.slice(1), this.begin));
    this.panel = buildPanel(element('controls'), {
      subjects: this.subjects, degree: data.degree, given: data.light.name,
      hasDropped: () => this.lighting.dropped?.name, canMatch: () => this.areAlike(),
    }, (key, value) => this.set({ [key]: value }), (file) => this.drop(file));
    element('name').textContent = data.subjects[0].title;
    this.listen();
    this.panel.build(this.state);
    this.set({});
  }

  valid(state) {
    return validState(state, { begin: this.begin, degree: this.data.degree, hasDropped: this.lighting.dropped !== null, vertices: this.subjects.map(({ vertices }) => vertices) });
  }

  get aspect() { return this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight); }
  get first() { return this.subjects[this.state.a]; }
  get second() { return this.subjects[this.state.b]; }

  /** Changes entries of the state; a picture follows. */
  set(changes) {
    const lightChanges = changes.light !== undefined && changes.light !== this.state.light;
    this.state = this.valid({ ...this.state, ...changes });
    if (lightChanges) {
      this.exposureIsKnown = false;
      this.refused = '';
    }
    this.panel.show(this.state);
    showTheme(this.state);
    clearTimeout(this.saving);
    this.saving = setTimeout(() => this.save(), 250);
    this.invalidate();
  }

  // Waits until the user rests.
  save() {
    const fragment = fragmentOf(this.state, this.begin);
    history.replaceState(null, '', fragment ? `#${fragment}` : location.pathname + location.search);
    element('ringing').textContent = this.lighting.ringingOf(this.state);
  }

  invalidate() {
    this.pending ??= requestAnimationFrame(() => {
      this.pending = undefined;
      this.draw();
    });
  }

  /** Relights a subject if something that it depends on has changed. */
  relight(subject) {
    const { state } = this;
    const light = this.lighting.of(state);
    const { ownSurface, exponent, specular, yaw, pitch, distance, target } = state;
    subject.place(state.time);
    const key = JSON.stringify([this.lighting.keyOf(light), subject.isStage && [subject.time, state.degree],
                                subject.dependsOnEye && [yaw, pitch, distance, target], subject.isGlossy && [ownSurface, exponent, specular]]);
    if (this.lit.get(subject) === key) return;
    subject.relight(light, state.degree, state, subject.isGlossy && ownSurface ? { exponent, specular: [specular, specular, specular] } : null);
    this.lit.set(subject, key);
    this.reference = undefined;
  }

  /** Whether both subjects show one mesh, vertex by vertex. */
  areAlike() {
    this.alike ??= new Map();
    const key = `${this.state.a} ${this.state.b}`;
    if (!this.alike.has(key)) this.alike.set(key, this.first.isLike(this.second));
    return this.alike.get(key);
  }

  draw() {
    const began = performance.now();
    const { gl, state } = this;
    const scale = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [Math.max(1, Math.round(this.canvas.clientWidth * scale)), Math.max(1, Math.round(this.canvas.clientHeight * scale))];
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
    this.relightShown();
    this.measure();
    gl.viewport(0, 0, width, height);
    const grey = greyOf(state.tone);
    gl.clearColor(grey, grey, grey, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const look = { exposure: this.exposure, tone: state.tone, light: this.lighting.of(state) };
    if (state.background === 'light') this.balls.draw(this.lighting.of(state), { ...look, toClip: directionsToClip(state, this.aspect), depth: false });
    this.isDifference = state.compare === 'difference' && this.areAlike();
    this.lobe = lobeOf(this.lighting.page.kernels, this.first, state.vertex);
    this.drawSubjects(width, height, look);
    if (state.balls) this.balls.drawCorner(state, scale, look, this.lighting.of(state), this.lobe && { ...this.lobe, accent: accentColor() });
    this.play(began);
    showTime(gl, began);
    showComparison(state, [this.first, this.second], this.isDifference, this.lobe !== null);
    showChosen(this.first, state.vertex, this.canvas, (place) => this.first.clipOf(place, state, this.aspect));
  }

  relightShown() {
    const { dropped } = this.lighting;
    const flaw = this.state.light === 'dropped' && dropped?.light.flaw ? `${dropped.name}: ${dropped.light.flaw}` : '';
    tell(this.refused || flaw);
    for (const subject of this.state.compare === 'none' ? [this.first] : [this.first, this.second]) {
      try {
        this.relight(subject);
      } catch (error) {
        if (!(error instanceof FileError)) throw error;
        tell(`${subject.name}: ${error.message}`);
      }
    }
  }

  // Time goes on while the stage plays: kSeconds for the whole of it.
  play(now) {
    const kSeconds = 8;
    const passed = this.played ? Math.min((now - this.played) / 1000, 0.25) : 0;
    this.played = this.state.playing ? now : undefined;
    if (this.state.playing) this.set({ time: (this.state.time + passed / kSeconds) % 1 });
  }

  get exposure() { return (this.state.exposure || this.measured) * 2 ** this.state.stops; }

  // The exposure stays until the kind of light changes or the user asks: the picture does not flicker.
  measure() {
    if (this.exposureIsKnown || this.state.exposure > 0) return;
    this.exposureIsKnown = true;
    const light = this.lighting.of(this.state);
    this.measured = this.picture.measure((mode) => this.first.draw(this.picture, this.state, 16 / 9, { mode, light }), () => this.first.read());
  }

  drawSubjects(width, height, look) {
    const { gl, state, picture, aspect } = this;
    if (this.isDifference) {
      this.reference ??= Math.sqrt(this.first.read().reduce((total, value, _, all) => total + (value * value) / all.length, 0)) || 1;
    }
    const middle = state.compare === 'wipe' ? Math.round(state.wipe * width) : width;
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, 0, middle, height);
    this.first.draw(picture, state, aspect, { ...look, reference: this.reference }, this.isDifference ? this.second : null);
    if (state.compare === 'wipe') {
      gl.scissor(middle, 0, width - middle, height);
      this.second.draw(picture, state, aspect, look);
    }
    gl.disable(gl.SCISSOR_TEST);
  }

  pick(x, y) {
    this.set({ vertex: this.first.pick(this.state, rayThrough(this.state, this.aspect, (2 * x) / this.canvas.clientWidth - 1, 1 - (2 * y) / this.canvas.clientHeight)) });
  }

  // Why a file is refused stays until the next one, or another light.
  async drop(file) {
    this.refused = '';
    tell('');
    try {
      this.lighting.dropped = { name: file.name, light: await lightOfFile(this.lighting.page, file, this.data.served) };
      this.panel.build(this.state);
      this.exposureIsKnown = false;
      this.set({ light: 'dropped' });
    } catch (error) {
      if (!(error instanceof FileError)) throw error;
      this.refused = `${file.name}: ${error.message}`;
      this.invalidate();
    }
  }

  key(key) {
    const { state } = this;
    const compares = this.subjects.length > 1 ? ['none', 'wipe', 'difference'] : ['none'];
    const actions = {
      '[': () => ({ stops: state.stops - 0.5 }), ']': () => ({ stops: state.stops + 0.5 }),
      ',': () => ({ degree: state.degree - 1 }), '.': () => ({ degree: state.degree + 1 }),
      e: () => { this.exposureIsKnown = false; return { exposure: 0 }; },
      c: () => ({ compare: compares[(compares.indexOf(state.compare) + 1) % compares.length] }),
      t: () => ({ theme: document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark' }),
      z: () => { this.exposureIsKnown = false; return this.begin; },
      ' ': () => ({ playing: this.subjects.some(({ moves }) => moves) && !state.playing }),
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
