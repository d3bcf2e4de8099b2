import {
  Box3,
  type BufferGeometry,
  DoubleSide,
  FrontSide,
  Group,
  Mesh,
  type Side,
  SRGBColorSpace,
  Texture,
} from 'three';
import {
  HatchingComposition,
  HatchingMaterial,
  type HatchingMaterialParameters,
  HatchingOutlines,
  SceneExtent,
} from 'three-hatching';
import { packedSide, packedSides } from '../../mesh/occlusion/occlusionSides.js';
import { cleanMesh } from '../files/mesh/cleanMesh.js';
import { type PictureRange, type PlainMesh, triangleCount } from '../files/mesh/PlainMesh.js';
import type { MeshPicture } from '../files/pictures/meshPictures.js';
import type { ReadMesh } from '../files/readModel.js';
import { bakeMesh } from './bakeMesh.js';
import { HatchedModel } from './HatchedModel.js';
import { meshesOf, someVertices } from './meshes.js';
import { statisticsOf } from './statistics.js';

/** The byte that stands for 1. */
const BYTE_ONE = 0xff;

/**
 * Writes precomputed ambient occlusion to a geometry, in the format of `bakeOcclusion`. The geometry has the corners of the mesh.
 *
 * @param occlusion the number of sides, 1 or 2. Then for each vertex of the mesh a byte for each side, front first, from 0 (open sky) to
 *   255 (fully occluded). Then for each corner on a sharp edge that differs from its vertex the index of the corner in three bytes,
 *   little-endian, and a byte for each side
 */
export function writeOcclusion({ index, attributes }: BufferGeometry, mesh: PlainMesh, occlusion: Uint8Array): void {
  const { array } = attributes.hatchNormal;
  const corners = (index ?? attributes.hatchNormal).count;
  const sides = occlusion[0];
  const write = (corner: number, at: number): void => {
    const [front, back] = [occlusion[at] / BYTE_ONE, occlusion[at + 1] / BYTE_ONE];
    array[4 * (index ? index.array[corner] : corner) + 3] = sides === 2 ? packedSides(front, back) : packedSide(front);
  };
  for (let corner = 0; corner < corners; corner++)
    write(corner, 1 + sides * (mesh.indices ? mesh.indices[corner] : corner));
  for (let i = 1 + (sides * mesh.positions.length) / 3; i + 2 + sides < occlusion.length; i += 3 + sides) {
    const corner = occlusion[i] + (occlusion[i + 1] << 8) + (occlusion[i + 2] << 16);
    if (corner < corners) write(corner, i + 3);
  }
}

/** The least number of bytes of precomputed occlusion. */
const sizeOf = ([sides]: Uint8Array, { positions }: PlainMesh): number => 1 + (sides * positions.length) / 3;

/**
 * Makes a hatched model of one mesh, with a material per range. See-through ranges become a separate mesh, which casts no shadow.
 *
 * @param known pictures of the ranges, whose bitmaps the model owns from now on, the up axis, and occlusion
 */
export async function modelOfMesh(
  mesh: PlainMesh,
  options: { adjacency?: boolean; signal: AbortSignal; onProgress: (progress: number) => void },
  { pictures = [], stands, occlusion }: Partial<Pick<ReadMesh, 'pictures' | 'stands' | 'occlusion'>> = {},
): Promise<HatchedModel> {
  const root = new Group();
  const textures = pictures.map((picture) => picture && textureOf(picture));
  const materials: HatchingMaterial[] = [];
  const outlines: HatchingOutlines[] = [];
  const free = (): void => {
    for (const one of outlines) one.dispose();
    for (const { geometry } of meshesOf(root)) geometry.dispose();
    for (const material of materials) material.dispose();
  };
  const parts = partsOf(mesh);
  let begun = 0;
  for (const part of parts) {
    const share = triangleCount(part) / triangleCount(mesh);
    const before = begun;
    const onProgress = (progress: number): void => options.onProgress(before + share * progress);
    begun += share;
    try {
      const baked = await bakeMesh(part, { ...options, onProgress, outlines: true });
      const made = materialsOf(part, baked.side, (picture) => ({
        map: textures[picture] ?? null,
        alphaTest: textures[picture] ? (pictures[picture]?.cutOut ?? 0) : 0,
      }));
      const drawn = new Mesh(baked.geometry, part.ranges ? made : made[0]);
      const lines = new HatchingOutlines(drawn);
      root.add(drawn.add(lines));
      materials.push(...made);
      outlines.push(lines);
    } catch (error) {
      free();
      throw error;
    }
  }
  const bounds = boundsOf(meshesOf(root));
  const solid = boundsOf(meshesOf(root).filter(({ material }) => [material].flat().some((one) => !one.transparent)));
  const composition = new HatchingComposition();
  composition.extent = new SceneExtent(root, bounds);
  for (const material of materials) material.composition = composition;
  // An incomplete occlusion file is ignored.
  const isOccluded = occlusion !== undefined && parts.length === 1 && occlusion.length >= sizeOf(occlusion, mesh);
  if (isOccluded) writeOcclusion(meshesOf(root)[0].geometry, mesh, occlusion);
  const model = new HatchedModel(
    root,
    solid.isEmpty() ? bounds : solid,
    someVertices(mesh.positions),
    stands,
    statisticsOf(root),
    undefined,
    materials,
    outlines,
    () => {
      free();
      for (const picture of pictures) picture?.bitmap.close();
    },
  );
  model.isOccluded = isOccluded;
  return model;
}

const boundsOf = (meshes: readonly Mesh[]): Box3 =>
  meshes.reduce((bounds, { geometry }) => bounds.union(geometry.boundingBox!), new Box3());

/** Splits a mesh into its opaque and its see-through ranges. */
function partsOf(mesh: PlainMesh): PlainMesh[] {
  const clear = mesh.ranges?.filter(({ isSeeThrough }) => isSeeThrough) ?? [];
  if (clear.length === 0) return [mesh];
  const solid = mesh.ranges!.filter(({ isSeeThrough }) => !isSeeThrough);
  return [solid, clear].filter(({ length }) => length > 0).map((ranges) => partOf(mesh, ranges));
}

/** A copy of some ranges of a mesh, with only the vertices they use. */
function partOf(mesh: PlainMesh, ranges: readonly PictureRange[]): PlainMesh {
  const indices = new Uint32Array(ranges.reduce((sum, { count }) => sum + count, 0));
  let start = 0;
  const moved = ranges.map((range) => {
    indices.set(mesh.indices!.subarray(range.start, range.start + range.count), start);
    start += range.count;
    return { ...range, start: start - range.count };
  });
  return cleanMesh({ ...mesh, indices, ranges: moved }).mesh;
}

/** @param usual the sides of ranges of which the file does not say it */
function materialsOf(
  {
    colors,
    isOneSided: isAllOneSided,
    ranges = [{ start: 0, count: 0, picture: -1, isOneSided: isAllOneSided }],
  }: PlainMesh,
  usual: Side,
  paintOf: (picture: number) => HatchingMaterialParameters,
): HatchingMaterial[] {
  return ranges.map(({ picture, isSeeThrough = false, isOneSided }) => {
    const glass = isSeeThrough ? { transparent: true, depthWrite: false } : {};
    return new HatchingMaterial({
      tilesPerObjectUnit: 1,
      vertexColors: colors !== null,
      side: isOneSided === undefined ? usual : isOneSided ? FrontSide : DoubleSide,
      ...paintOf(picture),
      ...glass,
    });
  });
}

function textureOf({ bitmap, wrapS, wrapT }: MeshPicture): Texture {
  const texture = new Texture(bitmap as ImageBitmap);
  // The bitmap is already upright.
  texture.flipY = false;
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = wrapS;
  texture.wrapT = wrapT;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}
