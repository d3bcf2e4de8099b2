import { type MapDrawing, type TaskOptions, TonalArtMap, type TonalArtMapSource } from 'three-hatching';

/** What a map is made of: how it is drawn, or the address of its files or images. */
export type SharedMapSource = MapDrawing | string | readonly string[];

/** How making a map is followed. Whoever asks first for a map is told; others share it. */
export type SharedMapOptions = Pick<TaskOptions, 'onProgress' | 'createWorker'>;

interface SharedMap {
  readonly map: Promise<TonalArtMap>;
  users: number;
}

/** Kept for good, as loaders of React Three Fiber keep what they load: a map that is asked for again is there at once. */
const maps = new Map<string, SharedMap>();

/** One map for all who ask for the same. One that could not be made is tried again by the next who asks. */
export function sharedMap(source: SharedMapSource, options: SharedMapOptions = {}): Promise<TonalArtMap> {
  const key = keyOf(source);
  const known = maps.get(key);
  if (known) return known.map;
  const map = isAddress(source)
    ? TonalArtMap.load(source as TonalArtMapSource, options)
    : TonalArtMap.generate({ ...source, ...options });
  maps.set(key, { map, users: 0 });
  map.catch(() => maps.delete(key));
  return map;
}

/** Notes that somebody draws with a shared map, until the returned function is called: with the last one it leaves the graphics card. */
export function retainMap(source: SharedMapSource): () => void {
  const shared = maps.get(keyOf(source));
  if (!shared) return () => {};
  shared.users++;
  let isUsed = true;
  return () => {
    if (!isUsed) return;
    isUsed = false;
    shared.users--;
    if (shared.users === 0) shared.map.then((map) => shared.users === 0 && map.dispose());
  };
}

/** Forgets a shared map, or all of them. Who has one keeps it. */
export function forgetMap(source?: SharedMapSource): void {
  if (source === undefined) maps.clear();
  else maps.delete(keyOf(source));
}

const isAddress = (source: SharedMapSource): source is string | readonly string[] =>
  typeof source === 'string' || Array.isArray(source);

function keyOf(source: SharedMapSource): string {
  if (isAddress(source)) return JSON.stringify(source);
  return JSON.stringify(Object.entries(source).sort(([a], [b]) => (a < b ? -1 : 1)));
}
