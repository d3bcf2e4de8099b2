import { BufferAttribute, BufferGeometry, DoubleSide, FrontSide, type Side } from 'three';
import { type HatchingStatistics, prepareHatchingGeometry } from 'three-hatching';
import { type PlainMesh, triangleCount } from '../files/mesh/PlainMesh.js';
import { isOpen } from './isOpen.js';

/** Up to so many triangles get adjacency also where nothing asks for it: then every technique draws them at once. */
const MOST_WITH_ADJACENCY = 200_000;

/** A mesh baked for hatching. */
export interface BakedMesh {
  geometry: BufferGeometry;
  statistics: HatchingStatistics;
  /** Open surfaces are drawn from both sides. */
  side: Side;
}

/**
 * Bakes a mesh for hatching, in the library's worker. Missing normals are computed there, with creases kept.
 *
 * @param options.adjacency whether techniques that ask for adjacency draw it, which takes six times the memory. Small meshes have it
 *   all the same
 * @param options.outlines whether contours, borders and creases are to be drawn too
 * @param options.form whether lines are to follow the form
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
