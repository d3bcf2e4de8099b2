import type { BufferGeometry } from 'three';
import type { PrepareHatchingGeometryOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { askingMaterials, crossingOf, type PlannedMesh } from './geometryPlans.js';
import { isBatched } from './surfaceMeshes.js';

/** For each geometry the material that says at which angle lines that follow the form cross on it, if there is one and no option does. */
export function crossingMaterials(
  planned: readonly PlannedMesh[],
  { form }: PrepareHatchingGeometryOptions,
): Map<BufferGeometry, HatchingMaterial> {
  const materials = new Map<BufferGeometry, HatchingMaterial>();
  if (typeof form === 'object' && form.crossAngle !== undefined) return materials;
  for (const plan of planned) {
    const asking = isBatched(plan.mesh) ? [] : askingMaterials(plan);
    // What draws strokes now may draw lines later.
    const crossing = crossingOf(asking) ?? asking[0];
    if (crossing && !materials.has(plan.geometry)) materials.set(plan.geometry, crossing);
  }
  return materials;
}
