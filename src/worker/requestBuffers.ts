import { bakeRequestBuffers, jointRequestBuffers } from '../bake/bakeRequestBuffers.js';
import { contourSearchBuffers } from '../features/contourSearchBuffers.js';
import { imageBuffers } from '../hatchImages/imageBuffers.js';
import { occlusionMeshBuffers, occlusionSceneBuffers } from '../occlusion/occlusionBuffers.js';
import type { TaskName, TaskRequest } from './tasks.js';

const buffersOf: { [Name in TaskName]: (request: TaskRequest<Name>) => ArrayBuffer[] } = {
  bakeCorners: bakeRequestBuffers,
  bakeIndexed: bakeRequestBuffers,
  bakeJointForms: jointRequestBuffers,
  bakePull: bakeRequestBuffers,
  searchContours: contourSearchBuffers,
  generateHatchImages: () => [],
  generateThresholds: () => [],
  completeHatchImages: imageBuffers,
  startOcclusion: occlusionMeshBuffers,
  addDirections: ({ scene }) => occlusionSceneBuffers(scene),
};

/** The buffers that are transferred with a request, so that the sender loses them. `runTask` has checked its type. */
export const requestBuffers = (name: TaskName, request: unknown): ArrayBuffer[] => buffersOf[name](request as never);
