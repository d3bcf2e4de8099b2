import { alphaOf } from '../pictures/alphaOf.js';
import type { GltfParts } from './parseGltf.js';

/** A picture more of which is half there is that of something seen through, and not one with clear parts. */
const MOST_HALF = 0.5;

interface BlendedMaterial {
  alphaMode?: string;
  pbrMetallicRoughness?: { baseColorFactor?: number[]; baseColorTexture?: { index: number } };
}

/** Gives blended materials, now that their pictures are decoded, the alpha of those pictures that are half there, in the place of the picture. */
export function settleBlendedPictures({ json, textures, bitmaps }: GltfParts): void {
  for (const { alphaMode, pbrMetallicRoughness: base } of (json as { materials?: BlendedMaterial[] }).materials ?? []) {
    const bitmap = bitmaps[textures[base?.baseColorTexture?.index ?? -1]?.image ?? -1];
    if (alphaMode !== 'BLEND' || !base || !bitmap) continue;
    const alpha = alphaOf(bitmap);
    if (!alpha || (alpha.half <= MOST_HALF && alpha.mean > 0)) continue;
    const [r, g, b, a] = base.baseColorFactor ?? [1, 1, 1, 1];
    base.baseColorFactor = [r, g, b, a * alpha.mean];
    delete base.baseColorTexture;
  }
}
