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
  Vector3,
} from 'three';
import {
  HatchingComposition,
  HatchingMaterial,
  type HatchingMaterialParameters,
  HatchingOutlines,
  SceneExtent,
} from 'three-hatching';
import { packedSide, packedSides } from '../../mesh/occlusion/occlusionSides.js';
import { SMALL_PARTS } from '../../mesh/smallParts.js';
import { cleanMesh } from '../files/mesh/cleanMesh.js';
import {
  boundsOf as boundsOfPoints,
  type PictureRange,
  type PlainMesh,
  triangleCount,
} from '../files/mesh/PlainMesh.js';
import type { MeshPicture } from '../files/pictures/meshPictures.js';
import type { ReadMesh } from '../files/readModel.js';
import { bakeMesh } from './bakeMesh.js';
import { HatchedModel } from './HatchedModel.js';
import { type ChooseHidden, partsOfMesh, withoutParts } from './ModelParts.js';
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
 * @param options.hidden chooses the parts that are left out; the rest stays where it is
 * @param known pictures of the ranges, whose bitmaps are closed with the last model that has them, the up axis, and occlusion
 */
export async function modelOfMesh(
  whole: PlainMesh,
  {
    hidden: chooseHidden,
    ...options
  }: {
    hidden?: ChooseHidden | undefined;
    adjacency?: boolean;
    signal: AbortSignal;
    onProgress: (progress: number) => void;
  },
  { pictures = [], stands, occlusion }: Partial<Pick<ReadMesh, 'pictures' | 'stands' | 'occlusion'>> = {},
): Promise<HatchedModel> {
  const hidden = whole.parts && chooseHidden ? chooseHidden(whole.parts.names) : [];
  const mesh = withoutParts(whole, hidden);
  const root = new Group();
  const textures = pictures.map((picture) => picture && textureOf(picture));
  const materials: HatchingMaterial[] = [];
  const outlines: HatchingOutlines[] = [];
  const free = (): void => {
    for (const one of outlines) one.dispose();
    for (const { geometry } of meshesOf(root)) geometry.dispose();
    for (const material of materials) material.dispose();
  };
  const parts = partsOf(mesh).filter((part) => triangleCount(part) > 0);
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
  const { bounds, solid } = hidden.length > 0 ? boundsOfWhole(whole) : boundsOfMeshes(meshesOf(root));
  const composition = new HatchingComposition();
  composition.extent = new SceneExtent(root, bounds);
  for (const material of materials) material.composition = composition;
  // An incomplete occlusion file is ignored.
  const isOccluded = occlusion !== undefined && parts.length === 1 && occlusion.length >= sizeOf(occlusion, mesh);
  if (isOccluded) writeOcclusion(meshesOf(root)[0].geometry, mesh, occlusion);
  const model = new HatchedModel(
    root,
    solid.isEmpty() ? bounds : solid,
    someVertices(whole.positions),
    stands,
    statisticsOf(root),
    undefined,
    materials,
    outlines,
    () => {
      free();
      for (const picture of pictures) if (picture) giveBack(picture);
    },
  );
  for (const picture of pictures) if (picture) users.set(picture, (users.get(picture) ?? 0) + 1);
  model.parts = partsOfMesh(whole, hidden, root);
  model.isOccluded = isOccluded;
  return model;
}

/** The number of models that have a picture. */
const users = new WeakMap<MeshPicture, number>();

/** Closes a picture that no other model has. */
function giveBack(picture: MeshPicture): void {
  const others = (users.get(picture) ?? 1) - 1;
  users.set(picture, others);
  if (others === 0) picture.bitmap.close();
}

/** The bounds of a model, and those of its solid parts, on which it stands. */
interface Bounds {
  bounds: Box3;
  solid: Box3;
}

function boundsOfMeshes(meshes: readonly Mesh[]): Bounds {
  const solid = meshes.filter(({ material }) => [material].flat().some((one) => !one.transparent));
  return { bounds: boundsOf(meshes), solid: boundsOf(solid) };
}

function boundsOfWhole({ positions, indices, ranges = [] }: PlainMesh): Bounds {
  const { low, high } = boundsOfPoints(positions);
  const bounds = new Box3(new Vector3(...low), new Vector3(...high));
  if (!ranges.some(({ isSeeThrough }) => isSeeThrough)) return { bounds, solid: bounds };
  const solid = new Box3();
  const point = new Vector3();
  for (const { start, count, isSeeThrough } of ranges) {
    for (let corner = start; corner < start + count && !isSeeThrough; corner++)
      solid.expandByPoint(point.fromArray(positions, 3 * indices![corner]));
  }
  return { bounds, solid };
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
    castsFronts: allCast,
    ranges = [{ start: 0, count: 0, picture: -1, isOneSided: isAllOneSided, castsFronts: allCast }],
  }: PlainMesh,
  usual: Side,
  paintOf: (picture: number) => HatchingMaterialParameters,
): HatchingMaterial[] {
  return ranges.map(
    ({ picture, paint = '', isOfSmallParts = false, isSeeThrough = false, mirrors = 0, isOneSided, castsFronts }) => {
      const glass = isSeeThrough ? { transparent: true, depthWrite: false } : {};
      return new HatchingMaterial({
        name: isOfSmallParts ? `${paint} in small parts` : paint,
        userData: isOfSmallParts ? { [SMALL_PARTS]: true } : {},
        tilesPerObjectUnit: 1,
        vertexColors: colors !== null,
        side: isOneSided === undefined ? usual : isOneSided ? FrontSide : DoubleSide,
        shadowSide: castsFronts ? FrontSide : null,
        ...(mirrors > 0 && { metalness: mirrors, roughness: 0 }),
        ...paintOf(picture),
        ...glass,
      });
    },
  );
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
