import { counted } from '../common/ModelError.js';
import type { PixelPicture, Surroundings } from '../common/Surroundings.js';
import type { GltfSampler, GltfTextureUse } from '../gltf/gltfDocument.js';
import type { GltfParts } from '../gltf/parseGltf.js';
import { OPAQUE_ALPHA } from '../mesh/vertexColors.js';
import type { ReadModel } from '../readModel.js';
import { TRANSMITTED } from '../scenes/resolveAlpha.js';
import { alphaOf, isHalfThere, isOpaque, pixelsOf } from './imageSize.js';

/** Decodes the pictures of a model. Should run in a worker, since a large picture takes seconds. */
export async function withPictures(
  model: ReadModel,
  onStage: (stage: string) => void,
  { decodePicture }: Pick<Surroundings, 'decodePicture'>,
): Promise<ReadModel> {
  if (model.kind === 'mesh') return model;
  const { parts } = model;
  const count = parts.pictures.filter(Boolean).length;
  // One at a time, because each briefly needs its full size in memory.
  let number = 0;
  let lost = 0;
  for (const [i, picture] of parts.pictures.entries()) {
    if (!picture) continue;
    onStage(`decoding picture ${++number} of ${count}`);
    const { content, width, height } = picture;
    try {
      parts.bitmaps[i] = await decodePicture(content, { width, height, flipY: false });
    } catch {
      lost++;
    }
  }
  resolveBlendedPictures(parts);
  resolveTransmittedPictures(parts);
  const notes = lost > 0 ? [counted(lost, 'damaged picture', 'left out')] : [];
  return { ...model, notes: [...model.notes, ...notes], lostPictures: (model.lostPictures ?? 0) + lost };
}

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
export function resolveBlendedPictures({ json, textures, bitmaps }: GltfParts): void {
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

/** A transmission texture and factor, kept in the written material until the picture is decoded. */
interface TransmittedPicture {
  factor: number;
  texture: GltfTextureUse;
}

interface Material {
  alphaMode?: string;
  pbrMetallicRoughness: { baseColorFactor?: number[] };
  extras?: { transmitted: TransmittedPicture };
}

interface Primitive {
  attributes: Record<string, number>;
  indices?: number;
  material?: number;
}

interface Json {
  materials: Material[];
  meshes: { primitives: Primitive[] }[];
  accessors: { bufferView: number; componentType: number; count: number; type: string }[];
  bufferViews: { buffer: number; byteLength: number }[];
}

const UINT = 5125;
/** Pictures are sampled at this size at most. */
const SIDE = 512;
/** Centres of the small triangles at which a triangle is sampled, as barycentric coordinates of its second and third corner. */
const PLACES = Array.from({ length: 4 }, (_, i) => i).flatMap((row) =>
  Array.from({ length: 4 - row }, (_, column) => [row, column]).flatMap(([r, c]) => [
    [(r + 1 / 3) / 4, (c + 1 / 3) / 4],
    ...(r + c < 3 ? [[(r + 2 / 3) / 4, (c + 2 / 3) / 4]] : []),
  ]),
);

/**
 * Examines the decoded transmission textures. Triangles that are mostly see-through become a primitive with a blended material; the others
 * stay as they are.
 */
function resolveTransmittedPictures(parts: GltfParts): void {
  const json = parts.json as Json;
  for (const [index, material] of [...(json.materials ?? [])].entries()) {
    if (!material.extras) continue;
    const { factor, texture } = material.extras.transmitted;
    delete material.extras;
    const { image, sampler } = parts.textures[texture.index] ?? {};
    const letThrough = lightThrough(parts.bitmaps[image ?? -1], sampler);
    if (!letThrough) continue;
    const [r, g, b, a] = material.pbrMetallicRoughness.baseColorFactor ?? [1, 1, 1, 1];
    const own = material.alphaMode === 'BLEND' ? a : 1;
    const alphaAt = (u: number, v: number): number => own * (1 - TRANSMITTED * factor * letThrough(u, v));
    let glass: number | undefined;
    const sum = { alpha: 0, triangles: 0 };
    for (const mesh of json.meshes) {
      mesh.primitives = mesh.primitives.flatMap((primitive) => {
        const split = primitive.material === index ? splitBy(parts, json, primitive, texture, alphaAt) : undefined;
        if (!split) return [primitive];
        sum.alpha += split.alpha;
        sum.triangles += split.clear.length / 3;
        glass ??= json.materials.push({ ...material }) - 1;
        return [
          ...(split.solid.length > 0 ? [{ ...primitive, indices: written(parts, json, split.solid) }] : []),
          { ...primitive, indices: written(parts, json, split.clear), material: glass },
        ];
      });
    }
    if (glass === undefined) continue;
    json.materials[glass] = {
      ...material,
      alphaMode: 'BLEND',
      pbrMetallicRoughness: { ...material.pbrMetallicRoughness, baseColorFactor: [r, g, b, sum.alpha / sum.triangles] },
    };
  }
}

/** Transmission at a texture coordinate, in [0, 1]: the red channel. Undefined if the pixels cannot be read. */
function lightThrough(
  picture: GltfParts['bitmaps'][number],
  { wrapS, wrapT }: NonNullable<GltfSampler> = {},
): ((u: number, v: number) => number) | undefined {
  if (!picture) return undefined;
  const [width, height] = sizeOf(picture);
  const data = pixelsOf(picture, width, height);
  if (!data) return undefined;
  return (u, v) => {
    const column = Math.min(Math.floor(width * wrapped(u, wrapS)), width - 1);
    const row = Math.min(Math.floor(height * wrapped(v, wrapT)), height - 1);
    return data[4 * (row * width + column)] / 255;
  };
}

function sizeOf(picture: NonNullable<GltfParts['bitmaps'][number]> | PixelPicture): [width: number, height: number] {
  const scale = Math.min(1, SIDE / Math.max(picture.width, picture.height));
  return [picture.width, picture.height].map((side) => Math.max(1, Math.round(scale * side))) as [number, number];
}

const [CLAMPED, MIRRORED] = [33071, 33648];

/** Wraps a texture coordinate to [0, 1] by the sampler's mode. */
function wrapped(place: number, wrap: number | undefined): number {
  if (!Number.isFinite(place)) return 0;
  if (wrap === CLAMPED) return Math.min(Math.max(place, 0), 1);
  if (wrap !== MIRRORED) return place - Math.floor(place);
  const turn = place - 2 * Math.floor(place / 2);
  return turn > 1 ? 2 - turn : turn;
}

/** Splits the corners of a primitive into those of mostly see-through triangles and the others; undefined if no triangle is see-through. */
function splitBy(
  { arrays }: GltfParts,
  { accessors }: Json,
  { attributes, indices }: Primitive,
  { texCoord = 0, extensions }: GltfTextureUse,
  alphaAt: (u: number, v: number) => number,
): { clear: number[]; solid: number[]; alpha: number } | undefined {
  const { offset = [0, 0], rotation = 0, scale = [1, 1], texCoord: other } = extensions?.KHR_texture_transform ?? {};
  const accessor = attributes[`TEXCOORD_${other ?? texCoord}`];
  if (accessor === undefined) return undefined;
  const uvs = new Float32Array(arrays[accessors[accessor].bufferView]);
  const list = indices === undefined ? undefined : new Uint32Array(arrays[accessors[indices].bufferView]);
  const count = list?.length ?? uvs.length / 2;
  const [cos, sin] = [Math.cos(rotation), Math.sin(rotation)];
  const placed = (u: number, v: number): number =>
    alphaAt(offset[0] + cos * scale[0] * u + sin * scale[1] * v, offset[1] - sin * scale[0] * u + cos * scale[1] * v);
  const [clear, solid]: number[][] = [[], []];
  let alpha = 0;
  for (let corner = 0; corner + 2 < count; corner += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => list?.[corner + k] ?? corner + k);
    let [sum, seen] = [0, 0];
    for (const [second, third] of PLACES) {
      const at = (axis: number): number =>
        uvs[2 * a + axis] * (1 - second - third) + uvs[2 * b + axis] * second + uvs[2 * c + axis] * third;
      const here = placed(at(0), at(1));
      if (here >= OPAQUE_ALPHA) continue;
      sum += here;
      seen++;
    }
    const isClear = 2 * seen >= PLACES.length;
    if (isClear) alpha += sum / seen;
    (isClear ? clear : solid).push(a, b, c);
  }
  return clear.length > 0 ? { clear, solid, alpha } : undefined;
}

/** Adds an accessor for indices. @returns its index */
function written({ arrays }: GltfParts, { accessors, bufferViews }: Json, indices: readonly number[]): number {
  const values = Uint32Array.from(indices);
  const bufferView = arrays.push(values.buffer) - 1;
  bufferViews.push({ buffer: 0, byteLength: values.byteLength });
  return accessors.push({ bufferView, componentType: UINT, count: values.length, type: 'SCALAR' }) - 1;
}
