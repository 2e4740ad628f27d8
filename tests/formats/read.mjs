// Engines' own readers on the files of `prt export`. Usage: node read.mjs READER FILE [DIRECTIONS]; prints JSON.
// DIRECTIONS is a JSON file of unit vectors in the axes of the format.
import { readFileSync } from 'node:fs';

const [reader, file, directions_file] = process.argv.slice(2);
const bytes = readFileSync(file);
const directions = directions_file ? JSON.parse(readFileSync(directions_file)) : [];

// The first chunk of a GLB file.
const json_of_glb = () => JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString());

const readers = {
  // three.js: what the renderer's light probes show, on the processor.
  async threejs() {
    const { ObjectLoader, Vector3 } = await import('three');
    const probe = new ObjectLoader().parse(JSON.parse(bytes));
    if (!probe.isLightProbe) throw new Error('no light probe');
    const at = (method) => directions.map((d) => probe.sh[method](new Vector3(...d), new Vector3()).toArray());
    return { radiance: at('getAt'), irradiance: at('getIrradianceAt'), intensity: probe.intensity };
  },

  // Babylon.js: as its loader of EXT_lights_image_based makes harmonics, and its shader function
  // computeEnvironmentIrradiance evaluates them. Its result is irradiance over pi.
  async babylon() {
    const { SphericalHarmonics } = await import('@babylonjs/core/Maths/sphericalPolynomial.js');
    const light = json_of_glb().extensions.EXT_lights_image_based.lights[0];
    const h = SphericalHarmonics.FromArray(light.irradianceCoefficients);
    h.scaleInPlace(light.intensity);
    h.convertIrradianceToLambertianRadiance();
    h.preScaleForRendering();
    const evaluate = ([x, y, z]) => {
      const sum = h.l00.clone();
      const add = (v, factor) => sum.addInPlace(v.scale(factor));
      add(h.l1_1, y), add(h.l10, z), add(h.l11, x);
      add(h.l2_2, y * x), add(h.l2_1, y * z), add(h.l20, 3 * z * z - 1), add(h.l21, z * x), add(h.l22, x * x - y * y);
      return sum.asArray().map((v) => Math.PI * v);
    };
    return { irradiance: directions.map(evaluate) };
  },

  // The pictures of EXT_lights_image_based, for their sizes.
  async images() {
    const document = json_of_glb();
    const light = document.extensions.EXT_lights_image_based.lights[0];
    const start = 28 + bytes.readUInt32LE(12);
    const size_of = (image) => {
      const view = document.bufferViews[document.images[image].bufferView];
      const png = bytes.subarray(start + view.byteOffset, start + view.byteOffset + view.byteLength);
      return [png.readUInt32BE(16), png.readUInt32BE(20), png[25]];  // width, height, color type
    };
    return { size: light.specularImageSize, sizes: light.specularImages.map((six) => six.map(size_of)) };
  },

  // three.js: the pictures of a KTX 1 file.
  async ktx() {
    const { KTXLoader } = await import('three/examples/jsm/loaders/KTXLoader.js');
    const pictures = new KTXLoader().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), true);
    const sizes = pictures.mipmaps.map(({ width, height, data }) => [width, height, data.length]);
    return { cube: pictures.isCubemap, levels: pictures.mipmapCount, sizes };
  },

  // three.js: the attributes of the one mesh, whose names three.js writes in lower case.
  async glb() {
    const { GLTFLoader } = await import('three/examples/jsm/loaders/GLTFLoader.js');
    const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
    const { scene } = await new GLTFLoader().parseAsync(buffer, '');
    scene.updateMatrixWorld(true);
    const meshes = [];
    scene.traverse((object) => object.isMesh && meshes.push(object));
    if (meshes.length !== 1) throw new Error(`${meshes.length} meshes`);
    const { attributes, index } = meshes[0].geometry;
    const arrays = Object.fromEntries(Object.entries(attributes).map(([name, a]) => [name, Array.from(a.array)]));
    return { attributes: arrays, indices: Array.from(index.array), matrix: meshes[0].matrixWorld.toArray() };
  },

  // three.js: the properties sh_transfer_* of a PLY file.
  async ply() {
    const { PLYLoader } = await import('three/examples/jsm/loaders/PLYLoader.js');
    const loader = new PLYLoader();
    const header = bytes.subarray(0, bytes.indexOf('end_header')).toString();
    const names = header.match(/sh_transfer_\d+/g) ?? [];
    loader.setCustomPropertyNameMapping({ transfer: names, albedo: ['red', 'green', 'blue'] });
    const geometry = loader.parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
    const array = (name) => Array.from(geometry.attributes[name]?.array ?? []);
    return {
      positions: array('position'), normals: array('normal'), transfer: array('transfer'), albedo: array('albedo'),
      width: names.length, indices: Array.from(geometry.index.array),
    };
  },

  // Khronos' validator of glTF.
  async validate() {
    const { default: validator } = await import('gltf-validator');
    const { issues } = await validator.validateBytes(new Uint8Array(bytes));
    return { errors: issues.numErrors, warnings: issues.numWarnings, infos: issues.numInfos, messages: issues.messages };
  },
};

console.log(JSON.stringify(await readers[reader]()));
