import { TRANSMITTED } from '../scenes/settleAlpha.js';
import type { GltfDocument, GltfMaterial, GltfTextureUse } from './gltfDocument.js';

/** The fields of a material whose textures can be drawn. */
const TEXTURES = ['normalTexture', 'occlusionTexture', 'emissiveTexture'] as const;

/** The index of a texture's image, in a readable format if there are several. */
export function textureSource({ textures }: GltfDocument, texture: number | undefined): number | undefined {
  const { source, extensions } = textures[texture ?? -1] ?? {};
  return (
    extensions?.EXT_texture_webp?.source ??
    source ??
    extensions?.EXT_texture_avif?.source ??
    extensions?.KHR_texture_basisu?.source
  );
}

/** Indices of the images that the materials of a document use. */
export function usedImages(document: GltfDocument): Set<number> {
  const used = new Set<number>();
  for (const material of document.materials) {
    const transmitted = transmittedBy(material)?.texture;
    for (const use of [baseColor(material).texture, transmitted, ...TEXTURES.map((key) => material?.[key])]) {
      const image = textureSource(document, use?.index);
      if (image !== undefined) used.add(image);
    }
  }
  return used;
}

/**
 * Reduces the materials of a document to what a hatching material uses: base colour, normals, occlusion, emission, alpha and sides.
 * Transmissive materials become see-through.
 *
 * @param hasImage whether an image is available; textures without one are left out
 */
export function drawnMaterials(document: GltfDocument, hasImage: (image: number) => boolean): object[] {
  const drawn = (use: GltfTextureUse | undefined): GltfTextureUse | undefined => {
    const image = textureSource(document, use?.index);
    return image !== undefined && hasImage(image) ? use : undefined;
  };
  return document.materials.map((material) => {
    const { name, alphaMode, alphaCutoff, doubleSided, emissiveFactor, extensions } = material ?? {};
    const { factor, texture } = baseColor(material);
    const transmitted = transmittedBy(material);
    // A transmission texture decides per triangle, once it is decoded.
    const isGlass = transmitted !== undefined && !transmitted.texture;
    const picture = drawn(transmitted?.texture);
    const [r, g, b, a] = factor ?? [1, 1, 1, 1];
    const alpha = (alphaMode === 'BLEND' ? a : 1) * (1 - TRANSMITTED * (transmitted?.factor ?? 0));
    // Without its emissive map, the whole surface would emit light, and none of it would be hatched.
    const hasGlow = !material?.emissiveTexture || drawn(material.emissiveTexture) !== undefined;
    const strength = extensions?.KHR_materials_emissive_strength;
    return {
      name,
      alphaMode: isGlass ? 'BLEND' : alphaMode,
      alphaCutoff,
      doubleSided,
      ...(hasGlow && { emissiveFactor }),
      pbrMetallicRoughness: {
        ...optional('baseColorFactor', isGlass ? [r, g, b, alpha] : factor),
        ...optional('baseColorTexture', drawn(texture)),
      },
      ...Object.assign({}, ...TEXTURES.map((key) => optional(key, drawn(material?.[key])))),
      ...(strength && { extensions: { KHR_materials_emissive_strength: strength } }),
      ...(transmitted && picture && { extras: { transmitted: { factor: transmitted.factor, texture: picture } } }),
    };
  });
}

/** The transmission of a material and its texture; undefined if there is none, or the material is cut out. */
function transmittedBy(
  material: GltfMaterial | undefined,
): { factor: number; texture?: GltfTextureUse | undefined } | undefined {
  const { transmissionFactor = 0, transmissionTexture } = material?.extensions?.KHR_materials_transmission ?? {};
  if (!(transmissionFactor > 0) || material?.alphaMode === 'MASK') return undefined;
  return { factor: Math.min(transmissionFactor, 1), texture: transmissionTexture };
}

/** The base colour of the older specular-glossiness extension, if the material has no other. */
function baseColor(material: GltfMaterial | undefined): {
  factor?: number[] | undefined;
  texture?: GltfTextureUse | undefined;
} {
  const { pbrMetallicRoughness: metal, extensions } = material ?? {};
  const gloss = metal ? undefined : extensions?.KHR_materials_pbrSpecularGlossiness;
  return {
    factor: metal?.baseColorFactor ?? gloss?.diffuseFactor,
    texture: metal?.baseColorTexture ?? gloss?.diffuseTexture,
  };
}

const optional = <Value>(key: string, value: Value | undefined): Record<string, Value> =>
  value === undefined ? {} : { [key]: value };
