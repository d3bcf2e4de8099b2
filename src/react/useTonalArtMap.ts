import { use, useEffect } from 'react';
import type { TonalArtMap } from 'three-hatching';
import { useStable } from './sameValue.js';
import {
  forgetMap,
  type MapAddress,
  retainMap,
  type SharedMapOptions,
  type SharedMapSource,
  sharedMap,
} from './sharedMaps.js';

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
