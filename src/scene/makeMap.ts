import { checkTonalArtMap, isTonalArtMap } from '../material/checkTonalArtMap.js';
import { isPromise } from '../mistakes/isPromise.js';
import { TonalArtMap } from '../tam/TonalArtMap.js';
import type { TaskOptions } from '../worker/TaskOptions.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';

/** What the option `tonalArtMap` asks for. */
export type WantedMap = NonNullable<ApplyHatchingOptions['tonalArtMap']> | null;

/** Returns the map for the materials that need one. A generated map is added to `disposables`. */
export async function makeMap(
  wanted: WantedMap,
  isNeeded: boolean,
  { signal, createWorker, onProgress }: TaskOptions,
  disposables: { dispose(): void }[],
): Promise<TonalArtMap | null> {
  if (!isToBeMade(wanted)) return wanted;
  if (!isNeeded) return null;
  if (typeof wanted === 'function') {
    const own = checkTonalArtMap(await wanted((progress) => onProgress?.(progress)));
    onProgress?.(1);
    return own;
  }
  const map = await TonalArtMap.generate({ ...wanted, signal, createWorker, onProgress });
  disposables.push(map);
  return map;
}

/** Whether the map does not exist yet: these are options to generate it, or a function that resolves with it. */
export const isToBeMade = (wanted: WantedMap): wanted is Exclude<WantedMap, TonalArtMap | null> =>
  typeof wanted === 'function' ||
  (typeof wanted === 'object' && wanted !== null && !isTonalArtMap(wanted) && !isPromise(wanted));
