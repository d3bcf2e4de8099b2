import { type TextureValue, tsl, type Value } from './values.js';

const { int, ivec2, textureSize } = tsl;

/** @param i integer index of the texel */
export function texelOf(i: Value, texture: TextureValue): Value {
  const width = int(textureSize(texture, 0).x);
  return ivec2(i.mod(width), i.div(width));
}
