import { alphaOf, isHalfThere, isOpaque } from '../pictures/alphaOf.js';
import type { GltfParts } from './parseGltf.js';

/** Materials with at least this opacity count as opaque. */
const ALMOST = 0.95;

interface BlendedMaterial {
  alphaMode?: string;
  pbrMetallicRoughness?: { baseColorFactor?: number[]; baseColorTexture?: { index: number } };
}

/**
 * Examines the decoded pictures of blended materials. A mostly half-transparent picture is replaced by its mean alpha in the material; a
 * picture without alpha makes its material opaque.
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
