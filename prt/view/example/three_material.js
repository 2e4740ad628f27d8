// A three.js mesh that is relit in its vertex shader. MODULE.md of prt/view describes the parts.
import * as THREE from 'three';
import { FileError, uniformsOf } from './relight.js';

const kTypes = { RGBA32F: THREE.FloatType, RGBA16F: THREE.HalfFloatType, RGBA8_SNORM: THREE.ByteType };

const kFragment = `
precision highp float;
uniform float exposure;
in vec3 radiance;
out vec4 color;
void main() {
    vec3 linear = clamp(exposure * radiance, 0.0, 1.0);
    color = vec4(mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308))), 1.0);
}`;

function textureOf({ format, width, height, array }) {
  const texture = new THREE.DataTexture(array, width, height, THREE.RGBAFormat, kTypes[format]);
  texture.internalFormat = format;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

function geometryOf({ attributes, transfer }) {
  const geometry = new THREE.BufferGeometry();
  for (const { name, components, array } of attributes) geometry.setAttribute(name, new THREE.BufferAttribute(array, components));
  geometry.setIndex(new THREE.BufferAttribute(transfer.sections.face, 1));
  return geometry;
}

/** A mesh of a loaded file, and setLight(light): the light is in the axes of the mesh. */
export function relitMesh(baked) {
  if (baked.runtime.shaders.lit.length > 0) throw new FileError('rows in clusters: use Relighter, or bake without --compress');
  const uniforms = { to_clip: { value: new THREE.Matrix4() }, eye: { value: new THREE.Vector3() }, exposure: { value: 1 } };
  for (const texture of baked.textures) uniforms[texture.name] = { value: textureOf(texture) };
  const material = new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3, uniforms, fragmentShader: kFragment,
    vertexShader: baked.runtime.shaders.relight.replace('#version 300 es\n', ''),
  });
  const mesh = new THREE.Mesh(geometryOf(baked), material);
  mesh.onBeforeRender = (renderer, scene, camera) => {
    const { to_clip: toClip } = uniforms;
    toClip.value.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).multiply(mesh.matrixWorld);
    uniforms.eye.value.setFromMatrixPosition(camera.matrixWorld).applyMatrix4(mesh.matrixWorld.clone().invert());
    material.uniformsNeedUpdate = true;
  };
  const setLight = (light) => {
    for (const [name, value] of Object.entries(uniformsOf(baked, light))) uniforms[name] = { value };
  };
  return { mesh, uniforms, setLight };
}
