/** Counterpart of shaders/chunks/levelByDepth.glsl. */
import { hatchingUniform } from '../base/uniforms.js';
import { tsl, type Value } from '../base/values.js';

const { log2 } = tsl;

/** Tiles per object unit. */
export const tilesPerUnit: Value = /* @__PURE__ */ hatchingUniform('tilesPerUnit', 'float');
/** Desired pixels per texel. */
const texelPixels = /* @__PURE__ */ hatchingUniform('texelPixels', 'float');

/** The level of a map for the depth of the fragment (paper, section 3.4). @param size texels per tile */
export const levelByDepth = (size: Value, unitsPerPixel: Value): Value =>
  log2(tilesPerUnit.mul(unitsPerPixel).mul(size).mul(texelPixels)).toVar();
