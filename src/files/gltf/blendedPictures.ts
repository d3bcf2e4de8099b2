import { alphaOf } from '../pictures/alphaOf.js';
import type { GltfParts } from './parseGltf.js';

/** A picture more of which is half there is that of something seen through, and not one with clear parts. */
const MOST_HALF = 0.5;
/** A material with no less opacity is opaque. */
const ALMOST = 0.95;
/** A picture with a greater mean alpha is opaque. */
const OPAQUE = 0.999;

interface BlendedMaterial {
  alphaMode?: string;
  pbrMetallicRoughness?: { baseColorFactor?: number[]; baseColorTexture?: { index: number } };
}

/**
 * Looks at the pictures of blended materials, now that they are decoded. The alpha of pictures that are half there goes to the material, in the
 * place of the picture; where a picture has none, the material is not blended by it.
 */
export function settleBlendedPictures({ json, textures, bitmaps }: GltfParts): void {
  for (const material of (json as { materials?: BlendedMaterial[] }).materials ?? []) {
    const { alphaMode, pbrMetallicRoughness: base } = material;
    const bitmap = bitmaps[textures[base?.baseColorTexture?.index ?? -1]?.image ?? -1];
    if (alphaMode !== 'BLEND' || !base || !bitmap) continue;
    const alpha = alphaOf(bitmap);
    const [r, g, b, a] = base.baseColorFactor ?? [1, 1, 1, 1];
    if (alpha && alpha.mean > OPAQUE && a >= ALMOST) material.alphaMode = 'OPAQUE';
    if (!alpha || (alpha.half <= MOST_HALF && alpha.mean > 0)) continue;
    base.baseColorFactor = [r, g, b, a * alpha.mean];
    delete base.baseColorTexture;
  }
}
