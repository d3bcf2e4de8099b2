import type { Texture } from 'three';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';

/**
 * What three.js builds a program by but looks at only once `needsUpdate` is set, as one number: whether there are textures and
 * which coordinates they go by, sides, vertex colours and the like. Another number needs another program.
 */
export function programSwitches(material: HatchingMaterialProperties & { normalMapType: number }): number {
  const { side, blending, normalMapType } = material;
  const { transparent, alphaHash, alphaToCoverage, dithering, premultipliedAlpha, vertexColors } = material;
  let switches: number = normalMapType;
  for (const name of textureNames) switches = switches * 16 + textureSwitches(material[name]);
  switches = switches * 4 + side;
  switches = switches * 8 + blending;
  for (const isOn of [transparent, alphaHash, alphaToCoverage, dithering, premultipliedAlpha, vertexColors]) {
    switches = switches * 2 + Number(isOn);
  }
  return switches;
}

const textureNames = [
  'map',
  'alphaMap',
  'normalMap',
  'bumpMap',
  'aoMap',
  'lightMap',
  'emissiveMap',
] as const satisfies (keyof HatchingMaterialProperties)[];

/** In [0, 16). */
function textureSwitches(texture: Texture | null): number {
  if (texture === null) return 0;
  return 1 + 2 * texture.channel + 8 * Number('isVideoTexture' in texture);
}
