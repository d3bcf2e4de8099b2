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

/** Stands in for a texture of outlines that holds integers, where there is nothing to draw. */
export const blankIntegers = (): DataTexture =>
  blank(new DataTexture(new Uint32Array(4), 1, 1, RGBAIntegerFormat, UnsignedIntType));

/** Stands in for one that holds floats. */
export const blankFloats = (): DataTexture => blank(new DataTexture(new Float32Array(4), 1, 1, RGBAFormat, FloatType));

/** Stands in for one that poses are drawn into: some versions of three.js turn what they have drawn, and look for it in the texture met first. */
export const blankPoses = (): Texture =>
  new RenderTarget(1, 1, { type: FloatType, minFilter: NearestFilter, magFilter: NearestFilter }).texture;

function repeated(texture: DataTexture): DataTexture {
  texture.wrapS = texture.wrapT = RepeatWrapping;
  return blank(texture);
}

/** Stands in for the tooth of paper: WebGPURenderer keeps the filter and the wrapping of the texture that it has met first. */
export const blankTooth: DataTexture = /* @__PURE__ */ (() => {
  const texture = new DataTexture(new Uint8Array(4), 1, 1, RedFormat);
  texture.magFilter = texture.minFilter = LinearFilter;
  return repeated(texture);
})();

/** Stands in for the places of dots. */
export const blankDots: DataTexture = /* @__PURE__ */ repeated(new DataTexture(new Uint8Array(4), 1, 1));
