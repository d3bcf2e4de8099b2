import { bakeRequestBuffers, jointRequestBuffers } from '../bake/bakeRequestBuffers.js';
import { detailRequestBuffers } from '../detail/DetailRequest.js';
import { contourSearchBuffers } from '../features/contourSearchBuffers.js';
import { imageBuffers } from '../hatchImages/imageBuffers.js';
import { occlusionMeshBuffers, occlusionSceneBuffers } from '../occlusion/occlusionBuffers.js';
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
