import type { BufferGeometry } from 'three';
import { type PrepareHatchingGeometryOptions, prepareHatchingGeometry } from '../geometry/prepareHatchingGeometry.js';

type Layout = PrepareHatchingGeometryOptions['layout'];

/**
 * Bakes geometries one after the other. An error in one does not stop the others.
 *
 * @param layouts the layout for each geometry
 * @param onBaked called with every geometry as soon as it is ready, so that it can be freed if a later one is aborted
 * @returns for each geometry the prepared one, or the TypeError or RangeError that says what is wrong with it
 */
export async function bakeGeometries(
  layouts: ReadonlyMap<BufferGeometry, Layout>,
  options: PrepareHatchingGeometryOptions,
  onBaked: (geometry: BufferGeometry) => void,
): Promise<Map<BufferGeometry, BufferGeometry | Error>> {
  const total = [...layouts.keys()].reduce((sum, geometry) => sum + cornerCount(geometry), 0);
  const results = new Map<BufferGeometry, BufferGeometry | Error>();
  let done = 0;
  let listenerFailed = false;
  const report = (corners: number): void => {
    try {
      options.onProgress?.(total > 0 ? corners / total : 1);
    } catch (error) {
      listenerFailed = true;
      throw error;
    }
  };
  for (const [geometry, layout] of layouts) {
    const corners = cornerCount(geometry);
    const onProgress = (progress: number): void => report(done + progress * corners);
    try {
      const prepared = await prepareHatchingGeometry(geometry, { ...options, layout, onProgress });
      onBaked(prepared);
      results.set(geometry, prepared);
    } catch (error) {
      const isFaulty = error instanceof TypeError || error instanceof RangeError;
      if (!isFaulty || listenerFailed || options.signal?.aborted) throw error;
      results.set(geometry, error);
    }
    done += corners;
    options.signal?.throwIfAborted();
  }
  report(total);
  return results;
}

const cornerCount = ({ index, attributes }: BufferGeometry): number => (index ?? attributes.position)?.count ?? 0;
