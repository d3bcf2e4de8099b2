import { type ApplyHatchingOptions, type MapDrawing, TonalArtMap } from 'three-hatching';
import { retainMap, sharedMap } from './sharedMaps.js';

/** Share of the progress for the map. */
const MAP_SHARE = 0.2;

/** The map that options name or ask for. One that is to be drawn is shared with all who ask for the same, and drawn once it is needed. */
export class WantedMap {
  /** What was taken so far. */
  map: TonalArtMap | null = null;
  /** Gives back what was taken. */
  release: () => void = () => {};

  constructor(private readonly options: ApplyHatchingOptions) {
    const { tonalArtMap } = options;
    if (tonalArtMap instanceof TonalArtMap) this.map = tonalArtMap;
  }

  /** As `applyHatching` takes it: what need not be drawn, or how to take it. */
  get source(): ApplyHatchingOptions['tonalArtMap'] {
    const { tonalArtMap } = this.options;
    return tonalArtMap === null || tonalArtMap instanceof TonalArtMap ? tonalArtMap : () => this.drawn();
  }

  /** To be called when something will be drawn with it. */
  async take(): Promise<void> {
    if (typeof this.source === 'function') await this.source();
  }

  private async drawn(): Promise<TonalArtMap> {
    if (this.map) return this.map;
    const { tonalArtMap, onProgress, createWorker } = this.options;
    if (typeof tonalArtMap === 'function') {
      this.map = await tonalArtMap();
      return this.map;
    }
    const drawing = { ...tonalArtMap } as MapDrawing;
    this.map = await sharedMap(drawing, {
      createWorker,
      onProgress: onProgress && ((progress) => onProgress(1 - MAP_SHARE + MAP_SHARE * progress)),
    });
    this.release = retainMap(drawing);
    return this.map;
  }
}
