import { ModelError } from '../common/ModelError.js';
import { baseName, readUri } from '../common/ModelFile.js';
import type { FindFile } from '../common/Surroundings.js';
import { fitPictures, imageSize, type PictureSize, PixelBudget } from '../pictures/imageSize.js';
import { TRANSMITTED } from '../scenes/resolveAlpha.js';
import type { AccessorValues } from './GltfValues.js';
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
function usedImages(document: GltfDocument): Set<number> {
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
 * Reduces the materials of a document to what a hatching material uses: base colour, metal, normals, occlusion, emission, alpha and sides.
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
        ...metalOf(material),
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

/** How metallic and rough a material is; where a picture says what is metal, nothing is. */
function metalOf(material: GltfMaterial | undefined): Partial<Record<'metallicFactor' | 'roughnessFactor', number>> {
  const { metallicFactor, roughnessFactor, metallicRoughnessTexture } = material?.pbrMetallicRoughness ?? {};
  if (metallicRoughnessTexture) return { metallicFactor: 0 };
  return { ...optional('metallicFactor', metallicFactor), ...optional('roughnessFactor', roughnessFactor) };
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

/** A picture to decode, and the size to draw it in. */
export interface Picture extends PictureSize {
  content: Blob;
}

/** The pictures to draw, by image index, and what is missing. */
interface Pictures {
  pictures: (Picture | undefined)[];
  /** Names of pictures that were not dropped along. */
  missing: string[];
  /** The number of pictures that could not be read. */
  lostPictures: number;
  notes: string[];
}

/** Collects the pictures that materials use. Sizes are read from headers, before anything is decoded. */
export async function collectPictures(
  document: GltfDocument,
  values: AccessorValues,
  findFile: FindFile,
): Promise<Pictures> {
  const used = usedImages(document);
  const pictures: (Picture | undefined)[] = document.images.map(() => undefined);
  const missing: string[] = [];
  let unreadable = 0;
  let tooLarge = 0;
  const budget = new PixelBudget();
  for (const [i, image] of document.images.entries()) {
    if (!used.has(i) || !image) continue;
    const { uri, bufferView } = image;
    const bytes = uri === undefined ? viewBytes(values, bufferView) : await readUri(uri, findFile);
    const [width, height] = (bytes && imageSize(bytes)) ?? [0, 0];
    if (!bytes && uri !== undefined && !uri.startsWith('data:')) missing.push(baseName(uri));
    else if (width * height === 0) unreadable++;
    else if (!budget.take(width, height)) tooLarge++;
    else pictures[i] = { content: new Blob([bytes as Uint8Array<ArrayBuffer>]), width, height, isReduced: false };
  }
  const notes = [...describe(unreadable, tooLarge), ...fitPictures(pictures.filter((one) => one !== undefined))];
  return { pictures, missing: [...new Set(missing)], lostPictures: unreadable + tooLarge, notes };
}

function viewBytes(values: AccessorValues, view: number | undefined): Uint8Array | undefined {
  try {
    return view === undefined ? undefined : values.viewOf(view);
  } catch (error) {
    if (error instanceof ModelError) return undefined;
    throw error;
  }
}

function describe(unreadable: number, tooLarge: number): string[] {
  const pictures = (count: number): string => `${count} ${count === 1 ? 'picture' : 'pictures'}`;
  const notes: string[] = [];
  if (unreadable > 0) notes.push(`${pictures(unreadable)} left out: not PNG, JPEG or WebP`);
  if (tooLarge > 0) notes.push(`${pictures(tooLarge)} left out: too large`);
  return notes;
}
