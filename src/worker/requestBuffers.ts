import { bakeRequestBuffers, jointRequestBuffers } from '../mesh/bake/bakeRequestBuffers.js';
import { detailRequestBuffers } from '../mesh/detail/DetailRequest.js';
import { contourSearchBuffers } from '../mesh/features/contourSearchBuffers.js';
import { imageBuffers } from '../strokes/tamImages/imageBuffers.js';
import { occlusionMeshBuffers, occlusionSceneBuffers } from '../mesh/occlusion/occlusionBuffers.js';
import type { TaskSet } from './TaskSet.js';
import type { BakingTasks } from './tasks.js';

/** The buffers that are transferred with a request, so that the sender loses them. */
export const requestBuffers: TaskSet<BakingTasks>['requestBuffers'] = {
  bakeCorners: bakeRequestBuffers,
  bakeIndexed: bakeRequestBuffers,
  bakeJointForms: jointRequestBuffers,
  bakePull: bakeRequestBuffers,
  searchContours: contourSearchBuffers,
  generateHatchImages: () => [],
  generateThresholds: () => [],
  completeHatchImages: imageBuffers,
  simplifyHatched: detailRequestBuffers,
  startOcclusion: occlusionMeshBuffers,
  addDirections: ({ scene, sums = [] }) => [...occlusionSceneBuffers(scene), ...sums.map(({ buffer }) => buffer)],
};
