import { bakeRequestBuffers } from '../bake/bakeRequestBuffers.js';
import { contourSearchBuffers } from '../features/contourSearchBuffers.js';
import { imageBuffers } from '../hatchImages/imageBuffers.js';
import { occlusionMeshBuffers, occlusionSceneBuffers } from '../occlusion/occlusionBuffers.js';
import type { TaskName, TaskRequest } from './tasks.js';

const buffersOf: { [Name in TaskName]: (request: TaskRequest<Name>) => ArrayBuffer[] } = {
  bake: bakeRequestBuffers,
  bakeIndexed: bakeRequestBuffers,
  bakePull: bakeRequestBuffers,
  searchContours: contourSearchBuffers,
  generateHatchImages: () => [],
  generateThresholds: () => [],
  completeHatchImages: imageBuffers,
  startOcclusion: occlusionMeshBuffers,
  addDirections: ({ scene }) => occlusionSceneBuffers(scene),
};

/** The buffers transferred with a request, whose type `runTask` has checked: the sender loses them. */
export const requestBuffers = (name: TaskName, request: unknown): ArrayBuffer[] => buffersOf[name](request as never);
