// Gaussian splats by the packages of others. Usage: node splats.mjs READER FILE, which prints JSON, or
// node splats.mjs write-spz JSON FILE VERSION.
import { readFileSync, writeFileSync } from 'node:fs';

const [action, file, ...more] = process.argv.slice(2);
const bytes = readFileSync(file);
const parts = ['positions', 'scales', 'rotations', 'alphas', 'colors', 'sh'];

const spz_module = async () => {
  const { default: make } = await import('@adobe/spz');
  return make({ print: () => {} });
};

const actions = {
  // SPZ by the library of Niantic Labs and Adobe: quaternions x, y, z, w; axes right, up, back.
  async spz() {
    const spz = await spz_module();
    const cloud = spz.loadSpzFromBuffer(new Uint8Array(bytes), { to: spz.CoordinateSystem.RUB });
    const arrays = Object.fromEntries(parts.map((part) => [part, Array.from(cloud[part])]));
    return { splats: cloud.numPoints, degree: cloud.shDegree, antialiased: cloud.antialiased, ...arrays };
  },

  async 'write-spz'() {
    const [out, version] = more;
    const spz = await spz_module();
    const given = JSON.parse(bytes);
    const cloud = { numPoints: given.splats, shDegree: given.degree, antialiased: true, extensions: [] };
    for (const part of parts) cloud[part] = Float32Array.from(given[part]);
    const options = { version: Number(version), from: spz.CoordinateSystem.RUB, sh1Bits: 8, shRestBits: 8 };
    writeFileSync(out, spz.saveSpzToBuffer(cloud, options));
    return {};
  },

  // three.js: the attributes of the one set of points, whose names three.js writes in lower case.
  async glb() {
    const { GLTFLoader } = await import('three/examples/jsm/loaders/GLTFLoader.js');
    const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
    const { scene } = await new GLTFLoader().parseAsync(buffer, '');
    const points = [];
    scene.traverse((object) => object.isPoints && points.push(object));
    if (points.length !== 1) throw new Error(`${points.length} sets of points`);
    const numbers = (a) => {
      const length = a.count * a.itemSize;
      return Array.from({ length }, (_, i) => a.getComponent(Math.floor(i / a.itemSize), i % a.itemSize));
    };
    const { attributes } = points[0].geometry;
    return Object.fromEntries(Object.entries(attributes).map(([name, a]) => [name, numbers(a)]));
  },
};

console.log(JSON.stringify(await actions[action]()));
