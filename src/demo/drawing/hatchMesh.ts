import { Group, Mesh } from 'three';
import { HatchingMaterial } from 'three-hatching';
import type { PlainMesh } from '../files/PlainMesh.js';
import { bakeMesh } from './bakeMesh.js';
import { HatchedModel } from './HatchedModel.js';

/** Makes a hatched model of one mesh. */
export async function hatchMesh(
  mesh: PlainMesh,
  options: { signal: AbortSignal; onProgress: (progress: number) => void },
): Promise<HatchedModel> {
  const { geometry, statistics, side } = await bakeMesh(mesh, options);
  const material = new HatchingMaterial({ strokeScale: 1, vertexColors: mesh.colors !== null, side });
  const root = new Group().add(new Mesh(geometry, material));
  return new HatchedModel(root, geometry.boundingBox!, statistics, undefined, [material], () => {
    geometry.dispose();
    material.dispose();
  });
}
