import { BufferAttribute, BufferGeometry, DoubleSide, FrontSide, type Side } from 'three';
import { type HatchingStatistics, prepareHatchingGeometry } from 'three-hatching';
import { type PlainMesh, triangleCount } from '../files/mesh/PlainMesh.js';
import { isOpen } from './statistics.js';

/** Meshes with up to this many triangles always get adjacency, so that every technique can draw them at once. */
const MOST_WITH_ADJACENCY = 200_000;

/** A mesh baked for hatching. */
export interface BakedMesh {
  geometry: BufferGeometry;
  statistics: HatchingStatistics;
  /** Open surfaces are double-sided. */
  side: Side;
}

/**
 * Bakes a mesh for hatching, in the library's worker. Missing normals are computed there, with creases kept.
 *
 * @param options.adjacency whether to add triangle adjacency, which takes six times the memory. Small meshes always have it
 * @param options.outlines whether to bake contours, borders and creases
 * @param options.form whether to bake form lines
 */
export async function bakeMesh(
  mesh: PlainMesh,
  {
    adjacency = false,
    ...options
  }: {
    adjacency?: boolean;
    outlines?: boolean;
    form?: boolean;
    signal?: AbortSignal;
    onProgress?: (progress: number) => void;
  } = {},
): Promise<BakedMesh> {
  const source = new BufferGeometry();
  source.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  if (mesh.indices) source.setIndex(new BufferAttribute(mesh.indices, 1));
  if (mesh.normals) source.setAttribute('normal', new BufferAttribute(mesh.normals, 3));
  if (mesh.colors) source.setAttribute('color', new BufferAttribute(mesh.colors, 3));
  if (mesh.uvs) source.setAttribute('uv', new BufferAttribute(mesh.uvs, 2));
  mesh.ranges?.forEach(({ start, count }, i) => {
    source.addGroup(start, count, i);
  });
  const geometry = await prepareHatchingGeometry(source, {
    ...options,
    adjacency: adjacency || triangleCount(mesh) <= MOST_WITH_ADJACENCY,
  });
  const statistics = geometry.userData.hatching as HatchingStatistics;
  return {
    geometry,
    statistics,
    side: isOpen(statistics) ? DoubleSide : FrontSide,
  };
}
