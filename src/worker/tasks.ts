import { bakeCorners, bakeCornersResultBuffers } from '../bake/bakeCorners.js';
import { bakeIndexed, bakeIndexedResultBuffers } from '../bake/bakeIndexed.js';
import { bakeJointForms, jointFormsBuffers } from '../bake/bakeJointForms.js';
import { bakePull, bakePullResultBuffers } from '../bake/bakePull.js';
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

/** A long computation that the worker can run. Requests and results are plain data. */
interface Task<Request, Result> {
  /** Yields its progress in [0, 1] every few milliseconds of work. */
  run(request: Request): Generator<number, Result, void>;
  /** The buffers that are transferred back with the result. */
  resultBuffers(result: Result): ArrayBuffer[];
}

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
  startOcclusion: /* @__PURE__ */ task({ run: startOcclusion, resultBuffers: occlusionSceneBuffers }),
  addDirections: /* @__PURE__ */ task({
    run: addDirections,
    resultBuffers: ({ scene, occlusions }) => [
      ...occlusionSceneBuffers(scene),
      ...occlusions.map(({ buffer }) => buffer),
    ],
  }),
};

export type TaskName = keyof typeof tasks;
export type TaskRequest<Name extends TaskName> = Parameters<(typeof tasks)[Name]['run']>[0];
export type TaskResult<Name extends TaskName> = Parameters<(typeof tasks)[Name]['resultBuffers']>[0];

/** The task called `name`, without its types, which `runTask` has checked. */
export const taskNamed = (name: TaskName): Task<unknown, unknown> => tasks[name] as unknown as Task<unknown, unknown>;
