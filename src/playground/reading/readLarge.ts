import { MOST_PIXELS } from '../../mesh/detail/chooseLevel.js';
import { clusterMesh } from '../../viewer/files/mesh/clusterMesh.js';
import { canDraw, triangleCount } from '../../viewer/files/mesh/PlainMesh.js';
import { hidesBacks, meanNormals, plainNormals } from '../../viewer/files/mesh/plainNormals.js';
import type { ReadMesh, ReadModel } from '../../viewer/files/readModel.js';

/** Meshes with more triangles are simplified before they are baked. */
const MANY_TRIANGLES = 2_000_000;

/**
 * Whether a model has too many triangles, by default more than a sheet shows. Models with pictures are not simplified, since vertices at
 * one place have several texture coordinates there.
 */
export const isTooFine = (model: ReadModel, most = MANY_TRIANGLES): model is ReadMesh =>
  model.kind === 'mesh' && !model.mesh.uvs && triangleCount(model.mesh) > most;

/** The model, without its pictures if it has too many triangles to be drawn with them. */
export function withoutHeavyPictures(model: ReadModel): ReadModel {
  if (model.kind !== 'mesh' || !model.mesh.uvs || canDraw(triangleCount(model.mesh))) return model;
  const { uvs: _, ranges = [], ...plain } = model.mesh;
  const hasGlass = ranges.some(({ isSeeThrough }) => isSeeThrough);
  const mesh = { ...plain, ...(hasGlass && { ranges: ranges.map((range) => ({ ...range, picture: -1 })) }) };
  return { ...model, mesh, pictures: [], notes: [...model.notes, 'too large to be drawn with its pictures'] };
}

/** A coarse copy of a model, to be drawn until it is simplified and baked. */
export function coarseModel(model: ReadMesh): ReadMesh {
  const mesh = clusterMesh(model.mesh);
  return { ...model, mesh, plainNormals: meanNormals(mesh), hidesBacks: hidesBacks(mesh) };
}

/**
 * The size in pixels up to which the deviation of a simplified model is invisible, rounded down to two digits.
 *
 * @param error in radii
 */
export function exactPixels(error: number): number {
  const pixels = (2 * MOST_PIXELS) / error;
  const unit = 10 ** (Math.floor(Math.log10(pixels)) - 1);
  return Math.floor(pixels / unit) * unit;
}

/** Simplifies the model to at most `most` triangles, by default as many as a sheet shows, and adds a note that says so. */
export async function simplified(
  model: ReadMesh,
  onProgress: (progress: number) => void,
  most?: number,
): Promise<ReadMesh> {
  const [{ MeshoptSimplifier }, { simplifyMesh }] = await Promise.all([
    import('meshoptimizer/simplifier'),
    import('../../viewer/files/mesh/simplifyMesh.js'),
  ]);
  await MeshoptSimplifier.ready;
  const { mesh, error } = simplifyMesh(model.mesh, MeshoptSimplifier, onProgress, most);
  const normals = plainNormals(mesh);
  const [all, drawn] = [model.mesh, mesh].map((one) => triangleCount(one).toLocaleString('en'));
  const share = (100 * error).toFixed(2);
  const pixels = exactPixels(error).toLocaleString('en');
  return {
    ...model,
    mesh,
    plainNormals: normals,
    hidesBacks: normals !== null && hidesBacks(mesh),
    simplified: { triangles: triangleCount(model.mesh), error },
    details: [
      ...model.details,
      `${drawn} of ${all} triangles are drawn, which lie within ${share} % of the radius from all of them: less than can be seen if the model is up to ${pixels} pixels across`,
    ],
  };
}
