import type { SurfaceRequest } from '../mesh/bake/bakeSurface.js';
import type { VertexWords } from '../mesh/bake/vertexWords.js';
import { fetchWorker } from './fetchWorker.js';
import type { MakeAgain } from './TaskClient.js';
import type { TaskOptions } from './TaskOptions.js';
import { buffersIn, type NameIn, type RequestOf, type ResultOf, type TaskSet, type Tasks } from './TaskSet.js';
import type { BakingTasks } from './tasks.js';
import { type CreateWorker, disposedError, type PoolsOf, poolIn, type WorkerPool } from './WorkerPool.js';

/** A request that is made again has new copies of the mesh and its attributes, and the same of all else. */
const ofMesh = ({ mesh, attributes }: SurfaceRequest & { attributes?: VertexWords[] }): ArrayBuffer[] =>
  buffersIn([mesh, attributes]);

/** The buffers that are transferred with a request, so that the sender loses them. */
const requestBuffers: TaskSet<BakingTasks>['requestBuffers'] = {
  bakeCorners: ofMesh,
  bakeIndexed: ofMesh,
  bakeJointForms: buffersIn,
  bakePull: ofMesh,
  searchContours: buffersIn,
  generateHatchImages: () => [],
  generateThresholds: () => [],
  completeHatchImages: buffersIn,
  simplifyHatched: buffersIn,
  startOcclusion: buffersIn,
  addDirections: buffersIn,
  orientChecked: buffersIn,
  lineSpacings: buffersIn,
  intersectOutlines: buffersIn,
};

/** The tasks that bake geometry and draw the images of maps. */
export const bakingTasks: TaskSet<BakingTasks> = {
  fetchTasks: async () => (await import('./tasks.js')).tasks,
  requestBuffers,
  fetchWorker,
};

const createNoWorker: CreateWorker = () => null;

/** The pools with a worker, by set of tasks and by `createWorker` function. */
const poolsOf: PoolsOf = /* @__PURE__ */ new Map();

/** What was said of the inlined workers: a page that refuses one refuses all. */
const warnings = /* @__PURE__ */ new Set<string>();

/** The number of calls of `disposeHatchingWorkers`. */
let disposals = 0;

/**
 * Runs a task in a worker: in one that `options.createWorker` creates, or else in the inlined one. Without workers it runs in
 * slices on the main thread. The buffers of `request` are transferred: pass copies of what you want to keep.
 *
 * @param makeAgain makes the same request again, so that the task can start over if its worker dies
 */
export const runTask = <Name extends NameIn<BakingTasks>>(
  name: Name,
  request: RequestOf<BakingTasks, Name>,
  options: TaskOptions = {},
  makeAgain?: MakeAgain<RequestOf<BakingTasks, Name>>,
): Promise<ResultOf<BakingTasks, Name>> => runTaskOf(bakingTasks, name, request, options, makeAgain);

/** Like `runTask`, for the tasks of any set. */
export async function runTaskOf<All extends Tasks, Name extends NameIn<All>>(
  set: TaskSet<All>,
  name: Name,
  request: RequestOf<All, Name>,
  options: TaskOptions = {},
  makeAgain?: MakeAgain<RequestOf<All, Name>>,
): Promise<ResultOf<All, Name>> {
  return (await poolFor(set, name, options)).run(name, request, options, makeAgain);
}

/** Starts a worker ahead of bakes, so that they need not wait for it. Its errors are left to the first of them. */
export async function startWorker(options: TaskOptions, task: NameIn<BakingTasks> = 'bakeIndexed'): Promise<void> {
  try {
    (await poolFor(bakingTasks, task, options)).start();
  } catch {}
}

async function poolFor<All extends Tasks>(
  set: TaskSet<All>,
  task: NameIn<All>,
  options: TaskOptions,
): Promise<WorkerPool<All>> {
  const disposalsBefore = disposals;
  // The worker is loaded with the first task.
  const createWorker = await (options.createWorker ?? fetchInlineWorker(set, task));
  if (disposals !== disposalsBefore) throw disposedError();
  return poolIn(poolsOf, set, createWorker, options.createWorker ? undefined : warnings);
}

async function fetchInlineWorker<All extends Tasks>(set: TaskSet<All>, task: NameIn<All>): Promise<CreateWorker> {
  return typeof Worker === 'undefined' ? createNoWorker : set.fetchWorker(task);
}

/**
 * Terminates every worker that three-hatching has started and rejects all pending requests. You will rarely need it: idle
 * workers end after a few seconds. The next request starts a new worker.
 */
export function disposeHatchingWorkers(): void {
  disposals++;
  for (const pools of poolsOf.values()) for (const pool of pools.values()) pool.dispose();
  poolsOf.clear();
}
