import { alphaOf, isHalfThere, isOpaque } from '../pictures/alphaOf.js';
import type { GltfParts } from './parseGltf.js';

/** A material with no less opacity is opaque. */
const ALMOST = 0.95;

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
    if (alpha && isOpaque(alpha) && a >= ALMOST) material.alphaMode = 'OPAQUE';
    if (!alpha || !isHalfThere(alpha)) continue;
    base.baseColorFactor = [r, g, b, a * alpha.mean];
    delete base.baseColorTexture;
  }
}
