import { type ApplyHatchingOptions, type StrokeStyleName, TonalArtMap } from 'three-hatching';
import { retainMap, sharedMap } from './sharedMaps.js';

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
