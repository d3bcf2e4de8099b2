import type { Material, Texture } from 'three';
import { failure } from './failure.js';
import type { OldLook } from './geometryPlans.js';
import type { SkippedMesh } from './HatchedScene.js';

/**
 * Sets a displaced geometry, to be baked, on looks whose materials have a displacement map. Scenes without such materials do not load
 * the code for it.
 *
 * @param unreadable receives the meshes that cannot be displaced
 */
export async function displaceMeshes(
  looks: readonly OldLook[],
  unreadable: SkippedMesh[],
): Promise<readonly OldLook[]> {
  if (!looks.some(isDisplaced)) return looks;
  const { Displacer } = await import('./Displacer.js');
  const displacer = new Displacer();
  return looks.flatMap((look) => {
    if (!isDisplaced(look)) return [look];
    try {
      return [{ ...look, geometry: displacer.displaced(look), flatGeometry: look.geometry }];
    } catch (error) {
      unreadable.push(failure(look.mesh, error as Error));
      return [];
    }
  });
}

const isDisplaced = ({ oldMaterial }: OldLook): boolean =>
  [oldMaterial].flat().some((material: Displaceable | null | undefined) => material?.displacementMap);

type Displaceable = Material & { displacementMap?: Texture | null };
