import { Group, Mesh } from 'three';
import { HatchingMaterial } from 'three-hatching';
import type { PlainMesh } from '../files/PlainMesh.js';
import { bakeMesh } from './bakeMesh.js';
import { DrawnModel } from './DrawnModel.js';

/** Makes a drawing of one mesh. */
export async function drawMesh(
  mesh: PlainMesh,
  options: { signal: AbortSignal; onProgress: (progress: number) => void },
): Promise<DrawnModel> {
  const { geometry, facts, side } = await bakeMesh(mesh, options);
  const material = new HatchingMaterial({ strokeScale: 1, vertexColors: mesh.colors !== null, side });
  const root = new Group().add(new Mesh(geometry, material));
  return new DrawnModel(root, geometry.boundingBox!, facts, undefined, [material], () => {
    geometry.dispose();
    material.dispose();
  });
}
