// A typed use of the module, which module_test.mjs compiles in strict mode: every name of relight.d.ts in a place that needs
// its type.
import { darkness, FileError, inDegree, load, numbersOf, Relighter, runtime, turned, uniformsOf } from './relight.js';
import type { Attribute, Baked, Light, NumberTexture, Runtime, Shape, Transfer } from './relight.js';

export function radianceOf(gl: WebGL2RenderingContext, bytes: Uint8Array, coefficients: number[][]): Float32Array {
  const baked: Baked = load(bytes, runtime);
  const light: Light = { degree: baked.transfer.shape.degree, values: Float64Array.from(coefficients.flat()) };
  const relighter = new Relighter(gl, baked);
  relighter.relight(turned(baked.kernels, light, [1, 0, 0, 0, 1, 0, 0, 0, 1]), { eye: [0, 0, 1], surface: { specular: [1, 1, 1], exponent: 3 } });
  relighter.relight(inDegree(light, 2));
  const buffer: WebGLBuffer = relighter.radiance;
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  const radiance = relighter.read(0, baked.transfer.vertices);
  relighter.dispose();
  return radiance;
}

export function described({ transfer, attributes, textures }: Baked): string {
  const shape: Shape = transfer.shape;
  const bytes = (one: NumberTexture): number => one.array.byteLength + one.width * one.height;
  const last: Attribute | undefined = attributes.at(-1);
  const kinds: Record<Transfer['kind'], string> = { DU: 'a', DS: 'b', DI: 'c', GU: 'd', GS: 'e', GI: 'f', DT: 'g' };
  return `${kinds[transfer.kind]} ${shape.count} ${transfer.indirect?.count ?? 0} ${textures.map(bytes).join()} ${last?.array.length}`;
}

export function arraysOf(baked: Baked, given: Runtime): [Float32Array | undefined, Float64Array, string[]] {
  try {
    return [uniformsOf(baked, darkness(3))['light'], numbersOf(baked.transfer, 0), given.shaders.lit.map(({ texture }) => texture)];
  } catch (error) {
    throw error instanceof FileError ? new Error(error.message) : error;
  }
}

// @ts-expect-error A light has its coefficients in double precision.
export const single: Light = { degree: 0, values: new Float32Array(3) };
// @ts-expect-error The module knows its kinds.
export const unknown: Transfer['kind'] = 'XX';
