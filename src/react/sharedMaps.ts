import { type MapDrawing, type TaskOptions, TonalArtMap, type TonalArtMapSource } from 'three-hatching';

/** What a map is made of: how it is drawn, or the address of its files or images. */
export type SharedMapSource = MapDrawing | MapAddress;

/** The address of the files of a map, or those of its images. */
export type MapAddress = string | readonly string[];

/** How making a map is followed. Whoever asks first for a map is told; others share it. */
export type SharedMapOptions = Pick<TaskOptions, 'onProgress' | 'createWorker'>;

/** Kept for good, as loaders of React Three Fiber keep what they load: a map that is asked for again is there at once. */
const loaded = new Map<string, Promise<TonalArtMap>>();

/** How many components draw with a map. */
const users = new WeakMap<TonalArtMap, number>();

/** One map for all who ask for the same. One that could not be made is tried again by the next who asks. */
export function sharedMap(source: SharedMapSource, options: SharedMapOptions = {}): Promise<TonalArtMap> {
  if (!isAddress(source)) return TonalArtMap.shared(source, options).ready;
  const key = JSON.stringify(source);
  const known = loaded.get(key);
  if (known) return known;
  const map = TonalArtMap.load(source as TonalArtMapSource, options);
  loaded.set(key, map);
  map.catch(() => loaded.delete(key));
  return map;
}

/** Notes that somebody draws with a shared map, until the returned function is called: with the last one it leaves the graphics card. */
export function retainMap(map: TonalArtMap): () => void {
  users.set(map, (users.get(map) ?? 0) + 1);
  let isUsed = true;
  return () => {
    if (!isUsed) return;
    isUsed = false;
    const others = users.get(map)! - 1;
    users.set(map, others);
    if (others === 0) map.dispose();
  };
}

/** Forgets a loaded map, or all of them. Who has one keeps it. */
export function forgetMap(address?: MapAddress): void {
  if (address === undefined) loaded.clear();
  else loaded.delete(JSON.stringify(address));
}

const isAddress = (source: SharedMapSource): source is MapAddress =>
  typeof source === 'string' || Array.isArray(source);
