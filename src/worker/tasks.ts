import { bakeCorners, bakeCornersResultBuffers } from '../mesh/bake/bakeCorners.js';
import { bakeIndexed, bakeIndexedResultBuffers } from '../mesh/bake/bakeIndexed.js';
import { bakeJointForms, jointFormsBuffers } from '../mesh/bake/bakeJointForms.js';
import { bakePull, bakePullResultBuffers } from '../mesh/bake/bakePull.js';
import { loadSimplifier } from '../mesh/detail/loadSimplifier.js';
import type { DetailLevels } from '../mesh/detail/makeLevels.js';
import { simplifyHatched } from '../mesh/detail/simplifyHatched.js';
import { type ContourSearchResult, searchContours } from '../mesh/features/contourCandidates.js';
import { addDirections } from '../mesh/occlusion/addDirections.js';
import { startOcclusion } from '../mesh/occlusion/startOcclusion.js';
import { contourSearchBuffers, occlusionSceneBuffers } from '../mesh/requestBuffers.js';
import type { ThresholdLevel } from '../strokes/tamImages/encodeThresholds.js';
import { generateHatchImages } from '../strokes/tamImages/generateHatchImages.js';
import { generateThresholds } from '../strokes/tamImages/generateThresholds.js';
import { imageBuffers } from '../strokes/tamImages/HatchImages.js';
import { completeHatchImages } from '../strokes/tamImages/makeLevels.js';
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
