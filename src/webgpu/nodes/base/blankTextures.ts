import {
  DataTexture,
  FloatType,
  LinearFilter,
  NearestFilter,
  RedFormat,
  RenderTarget,
  RepeatWrapping,
  RGBAFormat,
  RGBAIntegerFormat,
  type Texture,
  UnsignedIntType,
} from 'three';

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
