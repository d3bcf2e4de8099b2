import type { Texture } from 'three';
import { HATCHING_PROPERTIES, type HatchingPropertyName } from '../look/hatchingProperties.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';

/**
 * The properties that three.js reads for a program only after `needsUpdate` is set, packed into one number: the textures and their
 * channels, whether strokes are sized on the screen, sides, vertex colours and the like. If the number changes, the program must be
 * rebuilt. Allocates nothing.
 */
export function programSwitches(material: HatchingMaterialProperties & { normalMapType: number }): number {
  let switches: number = material.normalMapType;
  for (const name in HATCHING_PROPERTIES) {
    if (HATCHING_PROPERTIES[name as HatchingPropertyName].kind !== 'texture') continue;
    switches = switches * 16 + textureSwitches(material[name as HatchingPropertyName] as Texture | null);
  }
  switches = switches * 2 + Number(material.sizedOnScreen > 0);
  switches = switches * 4 + material.side;
  switches = switches * 8 + material.blending;
  switches = switches * 2 + Number(material.transparent);
  switches = switches * 2 + Number(material.alphaHash);
  switches = switches * 2 + Number(material.alphaToCoverage);
  switches = switches * 2 + Number(material.dithering);
  switches = switches * 2 + Number(material.premultipliedAlpha);
  return switches * 2 + Number(material.vertexColors);
}

/** The switches of one texture, in [0, 16). */
function textureSwitches(texture: Texture | null): number {
  if (texture === null) return 0;
  return 1 + 2 * texture.channel + 8 * Number('isVideoTexture' in texture);
}
