// Types of the module that `prt view FILE -o relight.js` writes. MODULE.md explains it.

/** Coefficients of incident radiance, W m^-2 sr^-1 times sqrt(sr): values (3, bands^2), red, green, blue; index l(l+1)+m. */
export interface Light {
  degree: number;
  values: Float64Array;
}

/** The numbers of a vertex: prt/transfer/shape.hpp. */
export interface Shape {
  channels: number;
  degree: number;
  resultDegree: number;
  meets: 'dot' | 'operator' | 'nothing';
  rows: number;
  columns: number;
  /** rows times columns. */
  count: number;
  element: 'single' | 'half' | 'byte';
  oneChannel: boolean;
  /** The columns that the file has; empty: all. */
  kept: number[];
  clusters: number;
  vectors: number;
  holdsCosine: boolean;
  holdsAlbedo: boolean;
}

/** One instance of a mesh in a model file, with one material. */
export interface Node {
  name: string;
  /** Its name, or empty. */
  material: string;
  /** From the axes of its own vertices, 3 x 4 numbers, row by row. */
  toWorld: number[];
  /** First and count of each run of faces. */
  faces: [number, number][];
}

/** A transfer file: its header, and its sections as they are stored. */
export interface Transfer {
  header: Record<string, unknown>;
  scene: string;
  kind: 'DU' | 'DS' | 'DI' | 'DT' | 'GU' | 'GS' | 'GI';
  isGlossy: boolean;
  shape: Shape;
  indirect: Shape | null;
  /** World = origin + unit * position. */
  frame: { origin: number[]; unit: number };
  vertices: number;
  faces: number;
  nodes: Node[];
  sections: Record<string, Float32Array | Uint32Array | Uint16Array | Int8Array>;
}

/** An attribute of the vertex shader, one entry a vertex. Attributes that a file has no data for are not listed: they read 0. */
export interface Attribute {
  name: string;
  location: number;
  components: number;
  array: Float32Array;
}

/** A texture that the vertex shader reads with texelFetch: four numbers a texel, row by row, nearest. */
export interface NumberTexture {
  name: string;
  format: 'RGBA32F' | 'RGBA16F' | 'RGBA8_SNORM';
  width: number;
  height: number;
  array: Float32Array | Uint16Array | Int8Array;
}

/** What `prt view` wrote for a file and those like it. */
export interface Runtime {
  shaders: {
    /** Of the header of the files that they relight. */
    needs: Record<string, unknown>;
    /** GLSL ES 3.00; writes `out vec3 radiance`, linear RGB. */
    relight: string;
    /** Passes before it, where rows are clustered. `Relighter` runs them. */
    lit: { shader: string; texture: string; rows: number; parts: number }[];
  };
  kernels: Record<string, string>;
}

export interface Baked {
  transfer: Transfer;
  runtime: Runtime;
  attributes: Attribute[];
  textures: NumberTexture[];
  /** Generated functions, such as rotate_l4(r, c, out). */
  kernels: Record<string, (...parameters: unknown[]) => unknown>;
}

/** A file that cannot be read, or a light that does not fit it; the message is one line without the file's name. */
export class FileError extends Error {}

export const runtime: Runtime;

/** Checks every byte as `prt` does. Throws FileError. */
export function load(bytes: Uint8Array, runtime: Runtime): Baked;

/** A light without radiance. */
export function darkness(degree: number): Light;

/** Without the bands above the degree, or with zeros there. */
export function inDegree(light: Light, degree: number): Light;

/** (R f)(s) = f(R^-1 s). kernels: of a Baked of the light's degree. r: 9 numbers, row by row. */
export function turned(kernels: Baked['kernels'], light: Light, r: ArrayLike<number>): Light;

/**
 * The uniforms of a light in the axes of the mesh: `light` vec3[], of glossy kinds also `samples` vec4[] and `row_scale`
 * float[]. Throws FileError for a light that needs columns which the file left out.
 */
export function uniformsOf(baked: Baked, light: Light): Record<string, Float32Array>;

/** The numbers of a vertex, decoded, (channels, rows, columns): for inspection. */
export function numbersOf(transfer: Transfer, vertex: number): Float64Array;

/** Relights on WebGL 2 by transform feedback. Leaves its programs, buffers and textures bound to nothing but unit 0 and up. */
export class Relighter {
  /** Throws FileError if the numbers need larger textures than the GPU has. */
  constructor(gl: WebGL2RenderingContext, baked: Baked);
  /** Linear RGB radiance of every vertex: vec3, 12 bytes each. */
  readonly radiance: WebGLBuffer;
  /** eye: in the coordinates of the mesh, for glossy kinds. surface: one lobe for all vertices. */
  relight(light: Light, options?: { eye?: ArrayLike<number>; surface?: { specular: ArrayLike<number>; exponent: number } | null }): void;
  /** Radiance (count, 3) from the GPU, of all vertices without arguments. */
  read(first?: number, count?: number): Float32Array;
  dispose(): void;
}
