import { DataTexture, FloatType, RGBAFormat, RGBAIntegerFormat, UnsignedIntType } from 'three';

function blank(texture: DataTexture): DataTexture {
  texture.needsUpdate = true;
  return texture;
}

/** Stands in for the textures of outlines that hold integers, where there is nothing to draw. */
export const blankIntegers: DataTexture = /* @__PURE__ */ blank(
  new DataTexture(new Uint32Array(4), 1, 1, RGBAIntegerFormat, UnsignedIntType),
);

/** Stands in for those that hold floats. */
export const blankFloats: DataTexture = /* @__PURE__ */ blank(
  new DataTexture(new Float32Array(4), 1, 1, RGBAFormat, FloatType),
);
