import { bakeCorners, bakeCornersResultBuffers } from '../bake/bakeCorners.js';
import { bakeIndexed, bakeIndexedResultBuffers } from '../bake/bakeIndexed.js';
import { bakeJointForms, jointFormsBuffers } from '../bake/bakeJointForms.js';
import { bakePull, bakePullResultBuffers } from '../bake/bakePull.js';
import { loadSimplifier } from '../detail/loadSimplifier.js';
import type { DetailLevels } from '../detail/makeLevels.js';
import { simplifyHatched } from '../detail/simplifyHatched.js';
import { type ContourSearchResult, searchContours } from '../features/contourCandidates.js';
import { contourSearchBuffers } from '../features/contourSearchBuffers.js';
import { completeHatchImages } from '../hatchImages/completeHatchImages.js';
import type { ThresholdLevel } from '../hatchImages/encodeThresholds.js';
import { generateHatchImages } from '../hatchImages/generateHatchImages.js';
import { generateThresholds } from '../hatchImages/generateThresholds.js';
import { imageBuffers } from '../hatchImages/imageBuffers.js';
import { addDirections } from '../occlusion/addDirections.js';
import { occlusionSceneBuffers } from '../occlusion/occlusionBuffers.js';
import { startOcclusion } from '../occlusion/startOcclusion.js';
import type { Task } from './TaskSet.js';

const task = <Request, Result>(definition: Task<Request, Result>): Task<Request, Result> => definition;

const thresholdBuffers = (levels: ThresholdLevel[]): ArrayBuffer[] =>
  levels.flatMap(({ thresholds, encoded }) => [thresholds.buffer as ArrayBuffer, encoded.buffer as ArrayBuffer]);

/** All tasks of the worker, by name. */
export const tasks = {
  bakeCorners: /* @__PURE__ */ task({ run: bakeCorners, resultBuffers: bakeCornersResultBuffers }),
  bakeIndexed: /* @__PURE__ */ task({ run: bakeIndexed, resultBuffers: bakeIndexedResultBuffers }),
  bakeJointForms: /* @__PURE__ */ task({ run: bakeJointForms, resultBuffers: jointFormsBuffers }),
  bakePull: /* @__PURE__ */ task({ run: bakePull, resultBuffers: bakePullResultBuffers }),
  searchContours: /* @__PURE__ */ task({
    run: searchContours,
    resultBuffers: ({ search }: ContourSearchResult) => contourSearchBuffers({ search }),
  }),
  generateHatchImages: /* @__PURE__ */ task({ run: generateHatchImages, resultBuffers: imageBuffers }),
  generateThresholds: /* @__PURE__ */ task({ run: generateThresholds, resultBuffers: thresholdBuffers }),
  completeHatchImages: /* @__PURE__ */ task({
    run: completeHatchImages,
    resultBuffers: (result) => [...imageBuffers(result), ...thresholdBuffers(result.thresholds)],
  }),
  simplifyHatched: /* @__PURE__ */ task({
    prepare: ({ simplifier }) => loadSimplifier(simplifier),
    run: simplifyHatched,
    resultBuffers: ({ indices }: DetailLevels) => [indices.buffer],
  }),
  startOcclusion: /* @__PURE__ */ task({ run: startOcclusion, resultBuffers: occlusionSceneBuffers }),
  addDirections: /* @__PURE__ */ task({
    run: addDirections,
    resultBuffers: ({ scene, occlusions }) => [
      ...occlusionSceneBuffers(scene),
      ...occlusions.map(({ buffer }) => buffer),
    ],
  }),
};

export type BakingTasks = typeof tasks;
