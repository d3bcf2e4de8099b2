import { bake, bakeRequestBuffers, bakeResultBuffers } from '../bake/bake.js';
import { bakeIndexed, bakeIndexedRequestBuffers, bakeIndexedResultBuffers } from '../bake/bakeIndexed.js';
import { bakePull, bakePullResultBuffers } from '../bake/bakePull.js';
import { completeHatchImages } from '../hatchImages/completeHatchImages.js';
import type { ThresholdLevel } from '../hatchImages/encodeThresholds.js';
import { generateHatchImages } from '../hatchImages/generateHatchImages.js';
import { generateThresholds } from '../hatchImages/generateThresholds.js';
import type { HatchImages } from '../hatchImages/HatchImages.js';

/** A long computation that the worker can run. Requests and results are plain data. */
interface Task<Request, Result> {
  /** Yields its progress in [0, 1] every few milliseconds of work. */
  run(request: Request): Generator<number, Result, void>;
  /** The buffers transferred with the request: the sender loses them. */
  requestBuffers(request: Request): ArrayBuffer[];
  /** The buffers transferred back with the result. */
  resultBuffers(result: Result): ArrayBuffer[];
}

const task = <Request, Result>(definition: Task<Request, Result>): Task<Request, Result> => definition;

const imageBuffers = ({ images }: HatchImages): ArrayBuffer[] =>
  images.flatMap((levels) => levels.map(({ buffer }) => buffer as ArrayBuffer));

const thresholdBuffers = (levels: ThresholdLevel[]): ArrayBuffer[] =>
  levels.flatMap(({ thresholds, encoded }) => [thresholds.buffer as ArrayBuffer, encoded.buffer as ArrayBuffer]);

/** Every task of the worker, by name. The client and the worker read this one table. */
export const tasks = {
  bake: task({ run: bake, requestBuffers: bakeRequestBuffers, resultBuffers: bakeResultBuffers }),
  bakeIndexed: task({
    run: bakeIndexed,
    requestBuffers: bakeIndexedRequestBuffers,
    resultBuffers: bakeIndexedResultBuffers,
  }),
  bakePull: task({ run: bakePull, requestBuffers: bakeRequestBuffers, resultBuffers: bakePullResultBuffers }),
  generateHatchImages: task({
    run: generateHatchImages,
    requestBuffers: () => [],
    resultBuffers: imageBuffers,
  }),
  generateThresholds: task({
    run: generateThresholds,
    requestBuffers: () => [],
    resultBuffers: thresholdBuffers,
  }),
  completeHatchImages: task({
    run: completeHatchImages,
    requestBuffers: (request) => imageBuffers(request),
    resultBuffers: (result) => [...imageBuffers(result), ...thresholdBuffers(result.thresholds)],
  }),
};

export type TaskName = keyof typeof tasks;
export type TaskRequest<Name extends TaskName> = Parameters<(typeof tasks)[Name]['run']>[0];
export type TaskResult<Name extends TaskName> = Parameters<(typeof tasks)[Name]['resultBuffers']>[0];

/** The task `name` without its types, which `runTask` has checked. */
export const taskNamed = (name: TaskName): Task<unknown, unknown> => tasks[name] as unknown as Task<unknown, unknown>;
