import type { BufferGeometry } from 'three';
import { type PrepareHatchingGeometryOptions, prepareHatchingGeometry } from '../geometry/prepareHatchingGeometry.js';
import { mostWorkers } from '../worker/WorkerPool.js';

type Layout = PrepareHatchingGeometryOptions['layout'];

/** A bake takes some hundred bytes per corner: no more than this are baked at the same time, unless one geometry has more. */
const MOST_CORNERS = 6_000_000;

/** A worker costs as much to start, and to compile its code, as a bake of some ten thousand triangles: less is not worth another. */
const LEAST_CORNERS = 600_000;

/** What is told while geometries are baked. */
export interface BakeListeners {
  /** With every geometry as soon as it is ready, so that it can be freed if a later one is aborted. */
  onBaked(geometry: BufferGeometry): void;
  /** With how many geometries are done, faulty ones included, and how many there are. */
  onCount?: ((done: number, total: number) => void) | undefined;
}

/**
 * Bakes geometries, several at a time if there is work for several workers. An error in one does not stop the others.
 *
 * @param layouts the layout for each geometry
 * @returns for each geometry the prepared one, or the TypeError or RangeError that says what is wrong with it
 */
export async function bakeGeometries(
  layouts: ReadonlyMap<BufferGeometry, Layout>,
  options: PrepareHatchingGeometryOptions,
  { onBaked, onCount }: BakeListeners,
): Promise<Map<BufferGeometry, BufferGeometry | Error>> {
  const total = [...layouts.keys()].reduce((sum, geometry) => sum + cornerCount(geometry), 0);
  const results = new Map<BufferGeometry, BufferGeometry | Error>();
  // What fails stops all others, and nothing is baked on behind the back of the caller.
  const stop = new AbortController();
  const { signal } = options;
  const abort = (): void => stop.abort(signal?.reason);
  signal?.addEventListener('abort', abort);
  if (signal?.aborted) abort();
  const tell = (listener: () => void): void => {
    if (stop.signal.aborted) return;
    try {
      listener();
    } catch (error) {
      stop.abort(error);
    }
  };

  let corners = 0;
  const report = (): void => options.onProgress?.(total > 0 ? corners / total : 1);
  async function bakeOne(geometry: BufferGeometry, layout: Layout): Promise<void> {
    const count = cornerCount(geometry);
    let share = 0;
    const onProgress = (progress: number): void => {
      corners += (progress - share) * count;
      share = progress;
      tell(report);
    };
    try {
      const prepared = await prepareHatchingGeometry(geometry, { ...options, layout, onProgress, signal: stop.signal });
      onBaked(prepared);
      results.set(geometry, prepared);
    } catch (error) {
      if (!(error instanceof TypeError || error instanceof RangeError) || stop.signal.aborted) {
        // The first reason stays.
        stop.abort(error);
        return;
      }
      results.set(geometry, error);
    }
    corners += (1 - share) * count;
    tell(() => onCount?.(results.size, layouts.size));
  }

  const lanes = Math.min(mostWorkers(), Math.ceil(total / LEAST_CORNERS));
  const running = new Set<Promise<void>>();
  let cornersRunning = 0;
  for (const [geometry, layout] of layouts) {
    const count = cornerCount(geometry);
    while (running.size > 0 && (running.size >= lanes || cornersRunning + count > MOST_CORNERS)) {
      await Promise.race(running);
    }
    if (stop.signal.aborted) break;
    cornersRunning += count;
    const task = bakeOne(geometry, layout).then(() => {
      cornersRunning -= count;
      running.delete(task);
    });
    running.add(task);
  }
  await Promise.all(running);
  signal?.removeEventListener('abort', abort);
  signal?.throwIfAborted();
  stop.signal.throwIfAborted();
  corners = total;
  report();
  // In the order of what was given, whatever was done first.
  return new Map([...layouts.keys()].map((geometry) => [geometry, results.get(geometry)!]));
}

const cornerCount = ({ index, attributes }: BufferGeometry): number => (index ?? attributes.position)?.count ?? 0;
