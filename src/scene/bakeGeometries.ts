import type { BufferGeometry } from 'three';
import type { PrepareHatchingGeometryOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import { prepareWithForm } from '../material/geometry/prepareHatchingGeometry.js';
import type { JointForm } from '../mesh/bake/bakeJointForms.js';
import { maxWorkers } from '../worker/TaskOptions.js';
import { cornerCount, type GeometryPlan } from './geometryPlans.js';
import { bakeGroups } from './jointForms.js';

/** The number of corners that are baked at a time, unless one geometry has more: a bake takes some hundred bytes per corner. */
const MAX_CORNERS = 6_000_000;

/** The number of corners that justify another worker: one takes as long to start as a bake of some ten thousand triangles. */
const CORNERS_PER_WORKER = 600_000;

/** The share of the work that the form takes, if it is baked. */
const FORM_SHARE = 0.75;

/** Listeners that are called while geometries are baked. */
interface BakeListeners {
  /** Called with every geometry as soon as it is ready, so that it can be freed if a later one is aborted. */
  onBaked(geometry: BufferGeometry): void;
  /** Called with the number of finished geometries, faulty ones included, and the number of all. */
  onCount?: ((done: number, total: number) => void) | undefined;
}

/**
 * Bakes geometries, several at a time if there is work for several workers, after the forms that they share. A faulty geometry does not
 * stop the others.
 *
 * @param plans the geometries, each with its options
 * @returns for each geometry the prepared one, or the TypeError or RangeError that names its fault
 */
export async function bakeGeometries(
  plans: ReadonlyMap<BufferGeometry, GeometryPlan>,
  options: PrepareHatchingGeometryOptions,
  listeners: BakeListeners,
): Promise<Map<BufferGeometry, BufferGeometry | Error>> {
  const grouped = new Map([...plans].filter(([, { group }]) => group));
  if (grouped.size === 0) return bakeEach(plans, new Map(), options, listeners);
  const share = (FORM_SHARE * cornersOf(grouped.keys())) / Math.max(1, cornersOf(plans.keys()));
  const [onForm, onBake] = progressParts(options.onProgress, [share, 1 - share]);
  const forms = await bakeGroups(grouped, { ...options, onProgress: onForm });
  return bakeEach(plans, forms, { ...options, onProgress: onBake }, listeners);
}

const cornersOf = (geometries: Iterable<BufferGeometry>): number =>
  [...geometries].reduce((sum, geometry) => sum + cornerCount(geometry), 0);

/** Bakes geometries with the forms that some of them share. */
async function bakeEach(
  plans: ReadonlyMap<BufferGeometry, GeometryPlan>,
  forms: ReadonlyMap<BufferGeometry, JointForm>,
  options: PrepareHatchingGeometryOptions,
  { onBaked, onCount }: BakeListeners,
): Promise<Map<BufferGeometry, BufferGeometry | Error>> {
  const total = cornersOf(plans.keys());
  const results = new Map<BufferGeometry, BufferGeometry | Error>();
  // Any other error stops all bakes, so that none goes on after the promise was rejected.
  const { signal } = options;
  const { stop, unlink } = stoppedWith(signal);
  const notify = (listener: () => void): void => {
    if (stop.signal.aborted) return;
    try {
      listener();
    } catch (error) {
      stop.abort(error);
    }
  };

  let corners = 0;
  const report = (): void => options.onProgress?.(total > 0 ? Math.min(corners / total, 1) : 1);
  async function bakeOne(geometry: BufferGeometry, { layout, form }: GeometryPlan): Promise<void> {
    const shared = forms.get(geometry) ?? 'alone';
    const count = cornerCount(geometry);
    let share = 0;
    const onProgress = (progress: number): void => {
      corners += (progress - share) * count;
      share = progress;
      notify(report);
    };
    try {
      const prepared = await prepareWithForm(
        geometry,
        { ...options, layout, form: shared !== 'light' && form, onProgress, signal: stop.signal },
        typeof shared === 'string' ? null : shared,
      );
      onBaked(prepared);
      results.set(geometry, prepared);
    } catch (error) {
      if (!(error instanceof TypeError || error instanceof RangeError) || stop.signal.aborted) {
        // Only the first reason counts; later calls of abort() have no effect.
        stop.abort(error);
        return;
      }
      results.set(geometry, error);
    }
    corners += (1 - share) * count;
    notify(() => onCount?.(results.size, plans.size));
  }

  const lanes = Math.min(maxWorkers(), Math.ceil(total / CORNERS_PER_WORKER));
  const running = new Set<Promise<void>>();
  let cornersRunning = 0;
  for (const [geometry, plan] of plans) {
    const count = cornerCount(geometry);
    while (running.size > 0 && (running.size >= lanes || cornersRunning + count > MAX_CORNERS)) {
      await Promise.race(running);
    }
    if (stop.signal.aborted) break;
    cornersRunning += count;
    const task = bakeOne(geometry, plan).then(() => {
      cornersRunning -= count;
      running.delete(task);
    });
    running.add(task);
  }
  await Promise.all(running);
  unlink();
  signal?.throwIfAborted();
  stop.signal.throwIfAborted();
  corners = total;
  report();
  // The results are in the order of `plans`, whichever bake finished first.
  return new Map([...plans.keys()].map((geometry) => [geometry, results.get(geometry)!]));
}

/** A controller that is aborted along with a signal until `unlink` is called. */
export function stoppedWith(signal: AbortSignal | undefined): { stop: AbortController; unlink: () => void } {
  const stop = new AbortController();
  const abort = (): void => stop.abort(signal?.reason);
  signal?.addEventListener('abort', abort);
  if (signal?.aborted) abort();
  return { stop, unlink: () => signal?.removeEventListener('abort', abort) };
}

/**
 * Divides a progress among concurrent parts: it is the weighted sum of theirs.
 *
 * @param shares the share of each part; together they are 1
 * @returns a listener for each part, or undefined if there is none for the whole
 */
export function progressParts<Shares extends readonly number[]>(
  onProgress: ((progress: number) => void) | undefined,
  shares: readonly [...Shares],
): { [Index in keyof Shares]: ((progress: number) => void) | undefined } {
  const missing = shares.slice();
  const listeners = shares.map((share, part) => {
    if (!onProgress) return undefined;
    return (progress: number): void => {
      missing[part] = share * (1 - progress);
      // The sum of what is missing ends at exactly 0.
      const sum = missing.reduce((all, one) => all + one, 0);
      onProgress(Math.max(0, 1 - sum));
    };
  });
  return listeners as { [Index in keyof Shares]: ((progress: number) => void) | undefined };
}
