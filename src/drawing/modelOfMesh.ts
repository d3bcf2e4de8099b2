import { Group, Mesh, SRGBColorSpace, Texture } from 'three';
import { HatchingMaterial, HatchingOutlines, SceneExtent } from 'three-hatching';
import type { PlainMesh } from '../files/mesh/PlainMesh.js';
import type { MeshPicture } from '../files/pictures/meshPictures.js';
import type { ReadMesh } from '../files/readModel.js';
import { bakeMesh } from './bakeMesh.js';
import { HatchedModel } from './HatchedModel.js';
import { outlineOf } from './outlineOf.js';
import { writeOcclusion } from './writeOcclusion.js';

/** The alpha below which a cut-out surface is not drawn. */
const CUT_OUT = 0.5;

/**
 * Makes a hatched model of one mesh, with a material for each of its pictures.
 *
 * @param known of it: the pictures of its ranges, whose bitmaps the model owns from now on, which of its axes points up, and its occlusion
 */
export async function modelOfMesh(
  mesh: PlainMesh,
  options: { adjacency?: boolean; signal: AbortSignal; onProgress: (progress: number) => void },
  { pictures = [], stands, occlusion }: Partial<Pick<ReadMesh, 'pictures' | 'stands' | 'occlusion'>> = {},
): Promise<HatchedModel> {
  const { geometry, statistics, side } = await bakeMesh(mesh, { ...options, outlines: true });
  // An incomplete file does not fit.
  const isOccluded = occlusion !== undefined && occlusion.length >= mesh.positions.length / 3;
  if (isOccluded) writeOcclusion(geometry, mesh, occlusion);
  const textures = pictures.map((picture) => picture && textureOf(picture));
  const root = new Group();
  const extent = new SceneExtent(root, geometry.boundingBox!);
  const materials = (mesh.ranges ?? [{ picture: -1 }]).map(({ picture }) => {
    const map = textures[picture] ?? null;
    const alphaTest = map && pictures[picture]?.cutOut ? CUT_OUT : 0;
    return new HatchingMaterial({ tilesPerUnit: 1, vertexColors: mesh.colors !== null, side, map, alphaTest, extent });
  });
  const drawn = new Mesh(geometry, mesh.ranges ? materials : materials[0]);
  const outlines = new HatchingOutlines(drawn);
  root.add(drawn.add(outlines));
  const model = new HatchedModel(
    root,
    geometry.boundingBox!,
    outlineOf(mesh.positions),
    stands,
    statistics,
    undefined,
    materials,
    [outlines],
    () => {
      outlines.dispose();
      geometry.dispose();
      for (const material of materials) material.dispose();
      for (const picture of pictures) picture?.bitmap.close();
    },
  );
  model.isOccluded = isOccluded;
  return model;
}

function textureOf({ bitmap, wrapS, wrapT }: MeshPicture): Texture {
  const texture = new Texture(bitmap as ImageBitmap);
  // The bitmap is the right way up already.
  texture.flipY = false;
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = wrapS;
  texture.wrapT = wrapT;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}
