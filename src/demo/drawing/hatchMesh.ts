import { Group, Mesh } from 'three';
import { HatchingLines, HatchingMaterial } from 'three-hatching';
import type { PlainMesh } from '../files/PlainMesh.js';
import { bakeMesh } from './bakeMesh.js';
import { HatchedModel } from './HatchedModel.js';

/** Makes a hatched model of one mesh. */
export async function hatchMesh(
  mesh: PlainMesh,
  options: { signal: AbortSignal; onProgress: (progress: number) => void },
): Promise<HatchedModel> {
  const { geometry, statistics, side } = await bakeMesh(mesh, { ...options, lines: true });
  const material = new HatchingMaterial({ strokeScale: 1, vertexColors: mesh.colors !== null, side });
  const drawn = new Mesh(geometry, material);
  const lines = new HatchingLines(drawn);
  const root = new Group().add(drawn.add(lines));
  return new HatchedModel(root, geometry.boundingBox!, statistics, undefined, [material], [lines], () => {
    lines.dispose();
    geometry.dispose();
    material.dispose();
  });
}
