import type { Object3D } from 'three';
import type { HatchingStatistics } from 'three-hatching';
import { placements } from '../files/scenes/placements.js';
import type { ModelStatistics } from './HatchedModel.js';
import { meshesOf } from './meshesOf.js';

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
