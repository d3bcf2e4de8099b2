import { BufferAttribute, BufferGeometry } from 'three';
import { prepareHatchingGeometry } from 'three-hatching';
import type { PlainMesh } from './PlainMesh.js';

/** A model ready to be drawn. */
export interface DrawnModel {
  geometry: BufferGeometry;
  hasColors: boolean;
  triangles: number;
  borderEdges: number;
  nonManifoldEdges: number;
  degenerateTriangles: number;
}

/** Bakes a mesh for hatching, in the library's worker; normals it does not have are made there, edges kept. */
export async function bakeModel(
  mesh: PlainMesh,
  options: { signal: AbortSignal; onProgress: (progress: number) => void },
): Promise<DrawnModel> {
  const source = new BufferGeometry();
  source.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  if (mesh.indices) source.setIndex(new BufferAttribute(mesh.indices, 1));
  if (mesh.normals) source.setAttribute('normal', new BufferAttribute(mesh.normals, 3));
  if (mesh.colors) source.setAttribute('color', new BufferAttribute(mesh.colors, 3));
  const geometry = await prepareHatchingGeometry(source, options);
  const { triangles, borderEdges, nonManifoldEdges, degenerateTriangles } = geometry.userData.hatching as DrawnModel;
  return { geometry, hasColors: mesh.colors !== null, triangles, borderEdges, nonManifoldEdges, degenerateTriangles };
}
