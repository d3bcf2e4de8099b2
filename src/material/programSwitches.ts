import type { Texture } from 'three';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';

/**
 * What three.js builds a program by but looks at only once `needsUpdate` is set, as one number: whether there are textures and
 * which coordinates they go by, sides, vertex colours and the like. Another number needs another program.
 */
export function programSwitches(material: HatchingMaterialProperties): number {
  const { side, blending } = material;
  const { transparent, alphaHash, alphaToCoverage, dithering, premultipliedAlpha, vertexColors } = material;
  let switches = textureSwitches(material.map) * 16 + textureSwitches(material.alphaMap);
  switches = switches * 4 + side;
  switches = switches * 8 + blending;
  for (const isOn of [transparent, alphaHash, alphaToCoverage, dithering, premultipliedAlpha, vertexColors]) {
    switches = switches * 2 + Number(isOn);
  }
  return switches;
}

/** In [0, 16). */
function textureSwitches(texture: Texture | null): number {
  if (texture === null) return 0;
  return 1 + 2 * texture.channel + 8 * Number('isVideoTexture' in texture);
}
