/** Uniforms and textures of the material that is being drawn, as nodes. */
import {
  DataTexture,
  FloatType,
  type IUniform,
  LinearFilter,
  type Material,
  NearestFilter,
  RedFormat,
  RenderTarget,
  RepeatWrapping,
  RGBAFormat,
  RGBAIntegerFormat,
  type Texture,
  UnsignedIntType,
} from 'three';
import { type TextureValue, threeNodes, tsl, type Value } from './values.js';

const { materialReference } = threeNodes;
const { int, ivec2, textureSize } = tsl;

type UniformType = 'float' | 'int' | 'vec2' | 'vec3' | 'vec4' | 'color' | 'mat3' | 'mat4';

const known = new Map<string, Value>();

/**
 * A node for a uniform of the material that is being drawn, read from its `uniforms`. All materials share the node, and so share programs.
 * The chunk that declares the uniform says what it means.
 *
 * @param type `float` for a flag: three.js evaluates one of type `bool` where it is used first, even inside a branch
 */
export function hatchingUniform(name: string, type: UniformType): Value {
  const key = `${name} ${type}`;
  let uniform = known.get(key);
  if (!uniform) {
    uniform = materialReference(`uniforms.${name}.value`, type) as unknown as Value;
    known.set(key, uniform);
  }
  return uniform;
}

/** A material with uniforms named as in GLSL. */
type WithUniforms = Material & { uniforms?: Record<string, IUniform> };

/**
 * A node for a texture uniform of the material that is being drawn.
 *
 * @param blank placeholder, of the format that the texture has. Each node needs its own: three.js 0.186 merges nodes that hold the same
 *   texture while a shader is built into one uniform
 */
export const hatchingTexture = (name: string, blank: Texture): TextureValue =>
  threeNodes
    .uniformTexture(blank)
    .onObjectUpdate(
      ({ material }) => (material as WithUniforms | null)?.uniforms?.[name]?.value ?? blank,
    ) as unknown as TextureValue;

function blank(texture: DataTexture): DataTexture {
  texture.needsUpdate = true;
  return texture;
}

/** Placeholder for an integer texture of outlines. */
export const blankIntegers = (): DataTexture =>
  blank(new DataTexture(new Uint32Array(4), 1, 1, RGBAIntegerFormat, UnsignedIntType));

/** Placeholder for a float texture of outlines. */
export const blankFloats = (): DataTexture => blank(new DataTexture(new Float32Array(4), 1, 1, RGBAFormat, FloatType));

/**
 * Placeholder for a texture that poses are rendered into: some versions of three.js flip render targets, as told by the first texture that
 * a node holds.
 */
export const blankPoses = (): Texture =>
  new RenderTarget(1, 1, { type: FloatType, minFilter: NearestFilter, magFilter: NearestFilter }).texture;

function repeated(texture: DataTexture): DataTexture {
  texture.wrapS = texture.wrapT = RepeatWrapping;
  return blank(texture);
}

/** Placeholder for the tooth of paper: WebGPURenderer keeps the filter and the wrapping of the first texture that a node holds. */
export const blankTooth: DataTexture = /* @__PURE__ */ (() => {
  const texture = new DataTexture(new Uint8Array(4), 1, 1, RedFormat);
  texture.magFilter = texture.minFilter = LinearFilter;
  return repeated(texture);
})();

/** Placeholder for the positions of dots. */
export const blankDots: DataTexture = /* @__PURE__ */ repeated(new DataTexture(new Uint8Array(4), 1, 1));

/** @param i integer index of the texel */
export function texelOf(i: Value, texture: TextureValue): Value {
  const width = int(textureSize(texture, 0).x);
  return ivec2(i.mod(width), i.div(width));
}
