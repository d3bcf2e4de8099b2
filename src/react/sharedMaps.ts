import {
  type ApplyHatchingOptions,
  type MapDrawing,
  type StrokeStyleName,
  type TaskOptions,
  TonalArtMap,
  type TonalArtMapSource,
} from 'three-hatching';

/** The source of a map: options to draw it, or the address of its files or images. */
export type SharedMapSource = MapDrawing | MapAddress;

/** The address of the files of a map, or those of its images. */
export type MapAddress = string | readonly string[];

/** Task options. Those of the first request for a map apply; later requests share the map. */
export type SharedMapOptions = Pick<TaskOptions, 'onProgress' | 'createWorker'>;

/** A cache that is never emptied by itself, like that of React Three Fiber's loaders. */
const loaded = new Map<string, Promise<TonalArtMap>>();

/** The number of components that draw with each map. */
const users = new WeakMap<TonalArtMap, number>();

/** The shared map of a source. If making it failed, the next request tries again. */
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

/** Counts a user of a shared map until the returned function is called. With the last user the map's GPU memory is freed. */
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

/** Removes a loaded map, or all of them, from the cache. Components keep theirs. */
export function forgetMap(address?: MapAddress): void {
  if (address === undefined) loaded.clear();
  else loaded.delete(JSON.stringify(address));
}

const isAddress = (source: SharedMapSource): source is MapAddress =>
  typeof source === 'string' || Array.isArray(source);

/** The map that the options specify. A generated map is made when it is needed, and shared by all components with the same options. */
export class WantedMap {
  /** The map, once it exists. */
  map: TonalArtMap | null = null;
  /** Releases the shared map. */
  release: () => void = () => {};

  constructor(private readonly options: ApplyHatchingOptions) {
    const { tonalArtMap } = options;
    if (tonalArtMap instanceof Promise) {
      throw new TypeError(
        '<Hatched>: tonalArtMap is a promise. Use useTonalArtMap(), or pass a function that returns it.',
      );
    }
    if (tonalArtMap instanceof TonalArtMap) this.map = tonalArtMap;
  }

  /** The option `tonalArtMap` of `applyHatching`: the map if it exists, or a function that makes it. */
  get source(): ApplyHatchingOptions['tonalArtMap'] {
    const { tonalArtMap } = this.options;
    return tonalArtMap === null || tonalArtMap instanceof TonalArtMap
      ? tonalArtMap
      : (onProgress) => this.drawn(onProgress);
  }

  /** Makes the map if it does not exist yet. Call this when the map is needed. */
  async take(): Promise<void> {
    const { onProgress = () => {} } = this.options;
    if (typeof this.source === 'function') await this.source(onProgress);
  }

  private async drawn(onProgress: (progress: number) => void): Promise<TonalArtMap> {
    if (this.map) return this.map;
    const { tonalArtMap, createWorker } = this.options;
    if (typeof tonalArtMap === 'function') {
      this.map = await tonalArtMap(onProgress);
      return this.map;
    }
    // A hand replaces the style.
    const hasHand = tonalArtMap && 'hand' in tonalArtMap && tonalArtMap.hand !== undefined;
    const style = hasHand ? undefined : namedStyle(this.options);
    this.map = await sharedMap({ style, ...tonalArtMap }, { createWorker, onProgress });
    this.release = retainMap(this.map);
    return this.map;
  }
}

/** The style among the parameters of the material. */
function namedStyle({ material }: ApplyHatchingOptions): StrokeStyleName | undefined {
  const { tonalArtMap } = typeof material === 'object' ? material : {};
  return typeof tonalArtMap === 'string' ? tonalArtMap : undefined;
}
