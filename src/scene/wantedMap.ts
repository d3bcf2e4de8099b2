import { isTonalArtMap } from '../material/checkTonalArtMap.js';
import { isPromise } from '../material/diagnostics/isPromise.js';
import type { TonalArtMap } from '../material/tam/TonalArtMap.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';

/** The option `tonalArtMap`. */
export type WantedMap = ApplyHatchingOptions['tonalArtMap'];

/** Whether the map does not exist yet: the option is a set of map options, or a function that resolves with a map. */
export const isToBeMade = (wanted: WantedMap): wanted is Exclude<WantedMap, TonalArtMap | null | undefined> =>
  typeof wanted === 'function' ||
  (typeof wanted === 'object' && wanted !== null && !isTonalArtMap(wanted) && !isPromise(wanted));
