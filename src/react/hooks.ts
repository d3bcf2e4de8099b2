import { use, useEffect, useRef, useState } from 'react';
import type { BufferGeometry } from 'three';
import { type PrepareHatchingGeometryOptions, prepareHatchingGeometry, type TonalArtMap } from 'three-hatching';
import { sameValue, useStable } from './sameValue.js';
import {
  forgetMap,
  type MapAddress,
  retainMap,
  type SharedMapOptions,
  type SharedMapSource,
  sharedMap,
} from './sharedMaps.js';

/** Options of `useHatchingGeometry`. */
export interface HatchingGeometryOptions extends Omit<PrepareHatchingGeometryOptions, 'signal'> {
  /** Called if the geometry cannot be prepared. By default the error goes to the nearest error boundary. */
  onError?: ((error: unknown) => void) | undefined;
}

interface Prepared {
  readonly source: BufferGeometry;
  readonly options: HatchingGeometryOptions;
  readonly geometry?: BufferGeometry;
  readonly error?: unknown;
}

/**
 * Prepares a geometry for `<hatchingMaterial>`, in a worker. Returns `null` until it is ready, so that you can draw something else in
 * the meantime. The result is disposed of when the component unmounts or the source changes. The hook does not suspend, because React
 * would create a source in the same component again with every attempt.
 *
 * ```tsx
 * const source = useMemo(() => new TorusKnotGeometry(), []);
 * const geometry = useHatchingGeometry(source, { outlines: true });
 * return geometry && <mesh geometry={geometry}><hatchingMaterial tonalArtMap={map} /></mesh>;
 * ```
 *
 * @param source the geometry, which is not changed; `null` while there is none yet
 */
export function useHatchingGeometry(
  source: BufferGeometry | null | undefined,
  options: HatchingGeometryOptions = {},
): BufferGeometry | null {
  const stable = useStable(options);
  const latest = useRef(options);
  useEffect(() => {
    latest.current = options;
  });
  const [prepared, setPrepared] = useState<Prepared | null>(null);
  useEffect(() => {
    if (!source) return;
    const abort = new AbortController();
    let made: BufferGeometry | undefined;
    const { onError: _onError, onProgress: _onProgress, ...baking } = stable;
    const onProgress = (progress: number): void => latest.current.onProgress?.(progress);
    prepareHatchingGeometry(source, { ...baking, onProgress, signal: abort.signal }).then(
      (geometry) => {
        if (abort.signal.aborted) return geometry.dispose();
        made = geometry;
        setPrepared({ source, options: stable, geometry });
      },
      (error: unknown) => {
        if (abort.signal.aborted) return;
        if (latest.current.onError) latest.current.onError(error);
        else setPrepared({ source, options: stable, error });
      },
    );
    return () => {
      abort.abort();
      made?.dispose();
    };
  }, [source, stable]);
  if (!prepared || prepared.source !== source || !sameValue(prepared.options, stable)) return null;
  if (prepared.error !== undefined) throw prepared.error;
  return prepared.geometry ?? null;
}

/**
 * Returns a tonal art map, and suspends until it is ready, so put a `<Suspense>` around the component. All components with the same
 * source share one map, including `<Hatched>`. Its GPU memory is freed when the last of them unmounts.
 *
 * ```tsx
 * const woodcut = useTonalArtMap({ style: 'woodcut' });
 * const mine = useTonalArtMap('/maps/mine/map.json');
 * ```
 *
 * @param source the options of `TonalArtMap.generate`, or the source of `TonalArtMap.load`. Default: the style `hatching`
 * @throws the error of `generate` or `load`, to the nearest error boundary
 */
export function useTonalArtMap(source: SharedMapSource = {}, options: SharedMapOptions = {}): TonalArtMap {
  const stable = useStable(source);
  const map = use(sharedMap(stable, options));
  useEffect(() => retainMap(map), [map]);
  return map;
}

/** Starts to make a map before a component needs it. */
useTonalArtMap.preload = (source: SharedMapSource = {}, options: SharedMapOptions = {}): void => {
  sharedMap(source, options).catch(() => {});
};

/** Removes a loaded map, or all of them, from the cache, so that the next component loads it again. */
useTonalArtMap.clear = (address?: MapAddress): void => forgetMap(address);
