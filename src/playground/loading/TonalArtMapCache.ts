import { type Hand, TonalArtMap } from 'three-hatching';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';

/** The settings that determine a tonal art map. */
export type MapSettings = Pick<Settings, 'mapStyle' | 'mapSize' | 'mapTones' | 'mapSeed'>;

export interface MapOptions {
  signal: AbortSignal;
  onProgress: (progress: number) => void;
}

/** Fetched with the first map. Generates tonal art maps for settings. Caches the latest few, and the user's own. */
export class TonalArtMapCache {
  private static readonly kept = 6;
  private readonly maps = new Map<string, TonalArtMap>();
  private own: TonalArtMap | undefined;
  /** Duration of the latest map of a hand, in milliseconds. */
  handTime = 0;
  /** Numbers that identify hands in cache keys. */
  private readonly hands = new WeakMap<Hand, number>();
  private handCount = 0;

  /** Stores the user's own map, for the style `file`, and disposes of the previous one. */
  keep(map: TonalArtMap): void {
    this.own?.dispose();
    this.own = map;
  }

  /**
   * Returns a cached map at once, or generates it. The present map must be passed as `inUse`, so that it is not disposed of.
   *
   * @param hand for the style `ownHand`
   */
  async get(
    settings: MapSettings,
    options: MapOptions,
    inUse: TonalArtMap | undefined,
    hand?: Hand,
  ): Promise<TonalArtMap> {
    if (settings.mapStyle === 'file' && this.own) return this.own;
    const key = this.keyOf(settings, hand);
    const start = performance.now();
    const known = this.maps.get(key);
    const map = known ?? (await TonalArtMap.generate({ ...drawingOf(settings, hand), ...options }));
    if (hand && !known && settings.mapSize === SETTINGS.mapSize.default) this.handTime = performance.now() - start;
    this.maps.delete(key);
    this.maps.set(key, map);
    for (const [oldKey, old] of this.maps) {
      if (this.maps.size <= TonalArtMapCache.kept) break;
      if (old === map || old === inUse) continue;
      old.dispose();
      this.maps.delete(oldKey);
    }
    return map;
  }

  /** Whether a map is cached. */
  has(settings: MapSettings, hand?: Hand): boolean {
    return this.maps.has(this.keyOf(settings, hand));
  }

  private keyOf(settings: MapSettings, hand: Hand | undefined): string {
    if (hand && !this.hands.has(hand)) this.hands.set(hand, ++this.handCount);
    const { size, tones, seed } = drawingOf(settings, hand);
    return `${hand ? this.hands.get(hand) : styleOf(settings)} ${size} ${tones} ${seed}`;
  }

  /** Disposes of the GPU textures of all maps; those in use are uploaded again. */
  releaseGraphics(): void {
    for (const map of this.maps.values()) map.dispose();
    this.own?.dispose();
  }
}

const styleOf = ({ mapStyle }: MapSettings) =>
  mapStyle === 'file' || mapStyle === 'ownHand' ? SETTINGS.mapStyle.default : mapStyle;

const drawingOf = (settings: MapSettings, hand: Hand | undefined) => ({
  ...(hand ? { hand } : { style: styleOf(settings) }),
  size: Number(settings.mapSize),
  tones: settings.mapTones,
  seed: settings.mapSeed,
});
