import {
  type ApplyHatchingOptions,
  type MapDrawing,
  type StrokeStyleName,
  type TaskOptions,
  TonalArtMap,
  type TonalArtMapSource,
  withPreset,
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
  /** The option `tonalArtMap` of `applyHatching`: the map if it exists, or a function that makes it. */
  readonly source: ApplyHatchingOptions['tonalArtMap'];
  /** Releases the shared map. */
  release: () => void = () => {};

  constructor(options: ApplyHatchingOptions) {
    const look = options.preset === undefined ? options : withPreset(options.preset, options);
    const { tonalArtMap } = look;
    if (tonalArtMap instanceof Promise) {
      throw new TypeError(
        '<Hatched>: tonalArtMap is a promise. Use useTonalArtMap(), or pass a function that returns it.',
      );
    }
    const isToDraw = tonalArtMap !== null && typeof tonalArtMap !== 'function' && !(tonalArtMap instanceof TonalArtMap);
    this.source = isToDraw ? (onProgress) => this.drawn(look, tonalArtMap, onProgress) : tonalArtMap;
  }

  private async drawn(
    { material, createWorker }: ApplyHatchingOptions,
    drawing: MapDrawing | undefined,
    onProgress: (progress: number) => void,
  ): Promise<TonalArtMap> {
    // A hand replaces the style.
    const style = drawing?.hand === undefined ? namedStyle(material) : undefined;
    const map = await sharedMap({ style, ...drawing }, { createWorker, onProgress });
    this.release();
    this.release = retainMap(map);
    return map;
  }
}

/** The style among the parameters of the material. */
function namedStyle(material: ApplyHatchingOptions['material']): StrokeStyleName | undefined {
  const { tonalArtMap } = typeof material === 'object' ? material : {};
  return typeof tonalArtMap === 'string' ? tonalArtMap : undefined;
}
