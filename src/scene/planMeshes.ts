import type { OldLook, PlannedMesh } from './geometryPlans.js';
import type { MaterialReplacer } from './MaterialReplacer.js';
import { worldMatrices, worldScale } from './worldMatrices.js';

/** Makes the new materials of meshes. It yields after each mesh, since a scene may have thousands of materials. */
export function* planMeshes(
  looks: readonly OldLook[],
  replacer: MaterialReplacer,
): Generator<number, PlannedMesh[], void> {
  const planned: PlannedMesh[] = [];
  for (const look of looks) {
    const scale = worldScale(worldMatrices(look.mesh));
    planned.push({ ...look, material: replacer.replacementFor(look.mesh, look.oldMaterial, scale) });
    yield planned.length / looks.length;
  }
  return planned;
}
