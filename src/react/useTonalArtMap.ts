import { use, useEffect } from 'react';
import type { TonalArtMap } from 'three-hatching';
import { forgetMap, retainMap, type SharedMapOptions, type SharedMapSource, sharedMap } from './sharedMaps.js';
import { useStable } from './useStable.js';

/**
 * A tonal art map. Suspends until it is there, so put a `<Suspense>` around. The same source gives the same map to all who ask
 * for it, `<Hatched>` among them; it leaves the graphics card with the last of them.
 *
 * ```tsx
 * const woodcut = useTonalArtMap({ style: 'woodcut' });
 * const mine = useTonalArtMap('/maps/mine/map.json');
 * ```
 *
 * @param source how it is drawn, as for `TonalArtMap.generate`, or what `TonalArtMap.load` loads. Default: the style `hatching`
 * @throws what `generate` or `load` reject with, to the nearest error boundary
 */
export function useTonalArtMap(source: SharedMapSource = {}, options: SharedMapOptions = {}): TonalArtMap {
  const stable = useStable(source);
  const map = use(sharedMap(stable, options));
  useEffect(() => retainMap(stable), [stable]);
  return map;
}

/** Begins to make a map before a component asks for it. */
useTonalArtMap.preload = (source: SharedMapSource = {}, options: SharedMapOptions = {}): void => {
  sharedMap(source, options).catch(() => {});
};

/** Forgets a map, or all of them, so that it is made anew. */
useTonalArtMap.clear = (source?: SharedMapSource): void => forgetMap(source);
