import type { Object3D } from 'three';
import type { HatchingStatistics } from 'three-hatching';
import { meshesOf, placements } from './meshes.js';

/** Statistics of the bake, summed over a model. */
export interface ModelStatistics {
  triangles: number;
  borderEdges: number;
  nonManifoldEdges: number;
  unpairedEdges: number;
  inconsistentEdges: number;
  degenerateTriangles: number;
}

/** Sums over all meshes. Instances and shared geometries count each time they are drawn. */
export function statisticsOf(root: Object3D): ModelStatistics {
  const sums: ModelStatistics = {
    triangles: 0,
    borderEdges: 0,
    nonManifoldEdges: 0,
    unpairedEdges: 0,
    inconsistentEdges: 0,
    degenerateTriangles: 0,
  };
  for (const mesh of meshesOf(root)) {
    const statistics = mesh.geometry.userData.hatching as HatchingStatistics | undefined;
    if (!mesh.visible || !statistics) continue;
    const count = placements(mesh).length;
    for (const key of Object.keys(sums) as (keyof ModelStatistics)[]) sums[key] += statistics[key] * count;
  }
  return sums;
}

/** Whether back faces can be visible: the surface has borders, or its windings are inconsistent. */
export const isOpen = ({
  borderEdges,
  unpairedEdges,
  inconsistentEdges,
}: Pick<ModelStatistics, 'borderEdges' | 'unpairedEdges' | 'inconsistentEdges'>): boolean =>
  borderEdges + unpairedEdges + inconsistentEdges > 0;
