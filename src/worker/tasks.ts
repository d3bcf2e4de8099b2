import { bakeCorners } from '../mesh/bake/bakeCorners.js';
import { bakeIndexed } from '../mesh/bake/bakeIndexed.js';
import { bakeJointForms } from '../mesh/bake/bakeJointForms.js';
import { bakePull } from '../mesh/bake/bakePull.js';
import { loadSimplifier } from '../mesh/detail/loadSimplifier.js';
import { simplifyHatched } from '../mesh/detail/simplifyHatched.js';
import { searchContours } from '../mesh/features/contourCandidates.js';
import { addDirections } from '../mesh/occlusion/addDirections.js';
import { startOcclusion } from '../mesh/occlusion/startOcclusion.js';
import { generateHatchImages } from '../strokes/tamImages/generateHatchImages.js';
import { generateThresholds } from '../strokes/tamImages/generateThresholds.js';
import { completeHatchImages } from '../strokes/tamImages/makeLevels.js';
import type { Task } from './TaskSet.js';

const task = <Request, Result>(
  run: Task<Request, Result>['run'],
  prepare?: Task<Request, Result>['prepare'],
): Task<Request, Result> => ({ run, prepare });

/** All tasks of the worker, by name. */
export const tasks = {
  bakeCorners: /* @__PURE__ */ task(bakeCorners),
  bakeIndexed: /* @__PURE__ */ task(bakeIndexed),
  bakeJointForms: /* @__PURE__ */ task(bakeJointForms),
  bakePull: /* @__PURE__ */ task(bakePull),
  searchContours: /* @__PURE__ */ task(searchContours),
  generateHatchImages: /* @__PURE__ */ task(generateHatchImages),
  generateThresholds: /* @__PURE__ */ task(generateThresholds),
  completeHatchImages: /* @__PURE__ */ task(completeHatchImages),
  simplifyHatched: /* @__PURE__ */ task(simplifyHatched, ({ simplifier }) => loadSimplifier(simplifier)),
  startOcclusion: /* @__PURE__ */ task(startOcclusion),
  addDirections: /* @__PURE__ */ task(addDirections),
};

export type BakingTasks = typeof tasks;
