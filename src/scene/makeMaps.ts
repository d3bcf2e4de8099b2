import { checkTonalArtMap } from '../material/propertyValues.js';
import type { TonalArtMap } from '../material/tam/TonalArtMap.js';
import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import type { MapDrawing } from '../strokes/tamImages/hatchImageOptions.js';
import type { TaskOptions } from '../worker/TaskOptions.js';
import { isToBeMade, type WantedMap } from './applyOptions.js';
import { progressParts } from './bakeGeometries.js';

/**
 * Returns the map for each style that materials name: the map of the option for all of them, or else the shared map of the style. A map
 * that belongs to this call alone is added to `disposables`.
 */
export async function makeMaps(
  wanted: WantedMap,
  styles: readonly StrokeStyleName[],
  options: TaskOptions,
  disposables: { dispose(): void }[],
): Promise<ReadonlyMap<StrokeStyleName, TonalArtMap | null>> {
  if (styles.length === 0) return new Map();
  if (wanted !== undefined) {
    const map = await makeMap(wanted, options, disposables);
    return new Map(styles.map((style) => [style, map]));
  }
  const listeners = progressParts(
    options.onProgress,
    styles.map(() => 1 / styles.length),
  );
  const maps = styles.map((style, i) => sharedMap({ style }, { ...options, onProgress: listeners[i] }));
  return new Map((await Promise.all(maps)).map((map, i) => [styles[i], map]));
}

async function makeMap(
  wanted: NonNullable<WantedMap> | null,
  options: TaskOptions,
  disposables: { dispose(): void }[],
): Promise<TonalArtMap | null> {
  if (!isToBeMade(wanted)) return wanted;
  const { signal, createWorker, onProgress } = options;
  if (typeof wanted === 'function') {
    const own = checkTonalArtMap(await wanted((progress) => onProgress?.(progress)));
    onProgress?.(1);
    return own;
  }
  if (namesStyleAlone(wanted)) return sharedMap(wanted, options);
  const { TonalArtMap } = await fetchMaps();
  const map = await TonalArtMap.generate({ ...wanted, signal, createWorker, onProgress });
  disposables.push(map);
  return map;
}

/** Imports the code of maps, which looks without a map do not need. */
const fetchMaps = () => import('../material/tam/TonalArtMap.js');

const namesStyleAlone = (drawing: MapDrawing): boolean =>
  Object.entries(drawing).every(([name, value]) => name === 'style' || value === undefined);

/** The shared map when it is ready. An abort ends the waiting, but not the drawing, which others may wait for too. */
async function sharedMap(drawing: MapDrawing, { signal, createWorker, onProgress }: TaskOptions): Promise<TonalArtMap> {
  signal?.throwIfAborted();
  const { TonalArtMap } = await fetchMaps();
  signal?.throwIfAborted();
  const { ready } = TonalArtMap.shared(drawing, { createWorker, onProgress });
  const aborted = new Promise<never>((_, reject) => {
    signal?.addEventListener('abort', () => reject(signal.reason), { once: true });
  });
  const map = await Promise.race([ready, aborted]);
  onProgress?.(1);
  return map;
}
