// What is shown at a time: a transfer file, or the objects of a stage, each with its own transfer, pose and light.
import { FileError, numbersOf, readTransfer } from './transfer_file.js';
import { kernelsOf } from './kernels.js';
import { bakedOf, inDegree, load, Relighter, requireKept, turned } from './relight.js';
import { withPixels } from './pixels.js';
import { capsSeenFrom, isTurned, placed, poseAt, unplaced, withoutCap } from './stage.js';
import { Volume } from './neighborhood.js';
import { applied, composed, transposed } from './vectors.js';
import { localEye, toClip } from './camera.js';
import { vertexAlong } from './pick.js';
import { DrawnMesh, sphereAround } from './picture.js';

/** Puts the name of a file before what is wrong with it. */
export function naming(name, make) {
  try {
    return make();
  } catch (error) {
    throw error instanceof FileError ? new FileError(`${name}: ${error.message}`) : error;
  }
}

/** A file of the page, checked: {name, bytes, baked}, or {name, bytes, volume}. `given` has its shaders. Throws FileError. */
export function fileOf(given, bytes, kernels) {
  if (given.isVolume) return naming(given.name, () => ({ name: given.name, bytes: bytes.length, volume: new Volume(readTransfer(bytes), kernelsOf(kernels)) }));
  return naming(given.name, () => ({ name: given.name, bytes: bytes.length, baked: withPixels(load(bytes, { shaders: given, kernels })) }));
}

// Rows in single precision, with all columns, that the page writes itself.
function bakedForRows({ transfer, runtime, pictures }, shaders) {
  const storage = { element: 'single', kept: [], clusters: 0, vectors: 0, storedChannels: 1, storedLength: transfer.shape.count };
  const { scale, cluster, weight, ...sections } = transfer.sections;
  sections.transfer = new Float32Array(transfer.vertices * transfer.shape.count);
  return { ...bakedOf({ ...transfer, shape: { ...transfer.shape, ...storage }, sections }, { ...runtime, shaders }), pictures };
}

class StagedObject {
  constructor(gl, given, files) {
    Object.assign(this, given);  // of a stage: axis, keys, proxy
    const file = files[given.file];
    this.file = file;
    this.volume = files[given.volume]?.volume;
    this.transfer = file.baked.transfer;
    this.gathersAtVertices = Boolean(given.rows);
    this.relighter = naming(file.name, () => new Relighter(gl, given.rows ? bakedForRows(file.baked, given.rows) : file.baked));
    this.mesh = new DrawnMesh(gl, this.relighter);
    const { degree } = this.transfer.shape;
    this.functions = { rotate: file.baked.kernels[`rotate_l${degree}`], basis: file.baked.kernels[`basis_l${degree}`] };
  }

  /** Vertex `index` in the axes of the object. */
  point(index) {
    const { sections: { position }, frame: { origin, unit: size } } = this.transfer;
    return origin.map((x, k) => x + size * position[3 * index + k]);
  }

  * points() { for (let v = 0; v < this.transfer.vertices; ++v) yield this.point(v); }

  /** Two opposite corners of the box around its vertices. */
  get corners() {
    const { position } = this.transfer.sections;
    const least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity];
    position.forEach((x, i) => {
      least[i % 3] = Math.min(least[i % 3], x);
      most[i % 3] = Math.max(most[i % 3], x);
    });
    const { origin, unit: size } = this.transfer.frame;
    return [least, most].map((corner) => corner.map((x, k) => origin[k] + size * x));
  }

  /** The row of a vertex under the shadows of the others: with the light it gives what the row gives with the shadowed light. */
  shadowedRow(index, highest, { caps, behind }) {
    const row = numbersOf(this.transfer, index).fill(0, (highest + 1) ** 2);
    const values = caps.reduceRight((rest, cap) => withoutCap(this.functions, highest, rest, cap), row);
    return behind ? behind(highest, values, true) : values;
  }

  shadowedLight(light, highest, { caps, behind }) {
    const n = (light.degree + 1) ** 2;
    const values = new Float64Array(3 * n);
    for (let c = 0; c < 3; ++c) {
      const own = light.values.slice(c * n, (c + 1) * n);
      const seen = behind ? behind(highest, own, false) : own;
      values.set(caps.reduce((channel, cap) => withoutCap(this.functions, highest, channel, cap), seen), c * n);
    }
    return { degree: light.degree, values };
  }
}

export class Subject {
  /** files: of the page, as fileOf gives them; number: its place among the subjects. */
  constructor(gl, { name, objects }, files, number) {
    this.number = number;
    this.objects = objects.map((given) => new StagedObject(gl, given, files));
    this.name = name;
    this.isStage = objects.some(({ keys }) => keys);
    this.moves = objects.some(({ keys = [] }) => keys.length > 1);
    this.isGlossy = this.objects.some(({ transfer }) => transfer.isGlossy);
    this.dependsOnEye = this.isGlossy;
    this.vertices = this.objects.reduce((sum, { transfer }) => sum + transfer.vertices, 0);
    this.bytes = [...new Set(objects.flatMap(({ file, volume }) => [files[file], files[volume]].filter(Boolean)))].reduce((sum, file) => sum + file.bytes, 0);
    this.place(0);
  }

  /** Puts the objects where they are at a time, and finds the sphere around all. */
  place(time) {
    if (this.time === time || (this.poses && !this.moves)) return;
    this.time = time;
    this.poses = this.objects.map((object) => poseAt(object, time));
    this.bounds = sphereAround((visit) => this.objects.forEach((object, k) => {
      const pose = this.poses[k];
      for (const point of isTurned(pose) ? object.points() : object.corners) visit(placed(pose, point));
    }));
  }

  /** Relights all objects under {degree, values} in the axes of the world, of which the bands up to `highest` count. */
  relight(light, highest, camera, surface) {
    this.objects.forEach((object, k) => {
      object.relighter.relight(this.lightAt(object, k, light, Math.min(highest, object.transfer.shape.degree)),
        { eye: localEye(camera, object.transfer.frame, this.poses[k]), surface, waits: object.mesh.hasPixels });
    });
  }

  // The light of an object in its axes; shadows at vertices go into the rows.
  lightAt(object, k, light, highest) {
    if (!this.isStage) return light;
    const own = inDegree(light, object.transfer.shape.degree);
    const seen = isTurned(this.poses[k]) ? turned(object.file.baked.kernels, own, transposed(this.poses[k].rotation)) : own;
    const shadowsAt = this.shadowsOn(k);
    if (!object.gathersAtVertices) return object.shadowedLight(seen, highest, shadowsAt(object.proxy.center));
    requireKept(object.transfer, object.shadowedLight(seen, highest, shadowsAt(object.point(0))));
    this.shadowRows(object, k, highest, shadowsAt);
    return seen;
  }

  // The shadows of the others at a point of object k: the caps that they cover, and what a volume makes of a function.
  shadowsOn(k) {
    const { degree } = this.objects[k].transfer.shape;
    const at = this.objects.findIndex(({ volume }, i) => volume && i !== k);
    const volume = this.objects[at]?.volume;
    const basis = volume?.basisOf(this.objects[k].functions.basis, degree, composed(transposed(this.poses[k].rotation), this.poses[at].rotation));
    return (point) => {
      const inWorld = placed(this.poses[k], point);
      const seen = volume?.seenFrom(unplaced(this.poses[at], inWorld));
      return { caps: capsSeenFrom(this.objects, this.poses, k, inWorld),
               behind: seen && ((highest, values, isRow) => volume.behind(seen, basis, highest, values, isRow)) };
    };
  }

  shadowRows(object, k, highest, shadowsAt) {
    const others = this.objects.map(({ proxy, volume }, i) => i === k || ((volume || proxy.radius > 0) && this.poses[i]));
    const key = JSON.stringify([highest, this.poses[k], others]);
    if (object.shadowed === key) return;
    object.shadowed = key;
    const { vertices, shape } = object.transfer;
    const rows = new Float32Array(vertices * shape.count);
    for (let v = 0; v < vertices; ++v) rows.set(object.shadowedRow(v, highest, shadowsAt(object.point(v))), v * shape.count);
    object.relighter.setNumbers('transfer', rows);
  }

  /** Radiance of all vertices, object after object: (vertices, 3). */
  read() {
    const out = new Float32Array(3 * this.vertices);
    let first = 0;
    for (const { relighter, transfer } of this.objects) {
      out.set(relighter.read(), first);
      first += 3 * transfer.vertices;
    }
    return out;
  }

  /** Draws the objects; with `other`, the difference from those of another subject. */
  draw(picture, camera, aspect, look, other = null) {
    this.objects.forEach(({ mesh }, k) => {
      if (other) mesh.compareWith(other.objects[k].relighter);
      picture.draw(mesh, { ...look, toClip: this.clipOf(k, camera, aspect), mode: other ? 1 : look.mode });
    });
  }

  clipOf(k, camera, aspect) { return toClip(camera, aspect, this.bounds, this.objects[k].transfer.frame, this.poses[k]); }

  /** What vertex `number` of all is: {object, index, place, pose}. */
  at(number) {
    let first = 0;
    const place = this.objects.findIndex(({ transfer }) => number < (first += transfer.vertices));
    const object = this.objects[place];
    return { object, place, index: number - first + object.transfer.vertices, pose: this.poses[place] };
  }

  /** The number of the vertex under the pointer, or -1. */
  pick(camera, direction) {
    let best = { vertex: -1, distance: Infinity }, first = 0;
    this.objects.forEach(({ transfer }, k) => {
      const hit = vertexAlong(transfer, localEye(camera, transfer.frame, this.poses[k]), applied(transposed(this.poses[k].rotation), direction));
      const distance = hit ? hit.distance * transfer.frame.unit : Infinity;
      if (distance < best.distance) best = { vertex: first + hit.vertex, distance };
      first += transfer.vertices;
    });
    return best.vertex;
  }

  /** Whether both show the same meshes, vertex by vertex. */
  isLike(other) {
    const same = (x, y) => x.length === y.length && x.every((value, i) => value === y[i]);
    return this.objects.length === other.objects.length && this.objects.every(({ transfer: { sections } }, k) => {
      const { sections: others } = other.objects[k].transfer;
      return same(sections.position, others.position) && same(sections.face, others.face);
    });
  }

  /** What it holds, in a line. */
  get facts() {
    const { kind, shape } = this.objects[0].transfer;
    const stored = shape.count === 0 ? '' : `, ${shape.clusters ? `${shape.clusters} clusters` : shape.element}`;
    const what = this.isStage ? `Stage, ${this.objects.length} objects` : `${kind}, degree ${shape.degree}${stored}`;
    return `${what} · ${this.vertices.toLocaleString('en')} vertices · ${(this.bytes / 2 ** 20).toFixed(2)} MiB`;
  }
}
