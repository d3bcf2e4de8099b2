import type { Hand, TonalArtMap } from 'three-hatching';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';

/** The settings that say which map is drawn. */
export type MapSettings = Pick<Settings, 'mapStyle' | 'mapSize' | 'mapTones' | 'mapSeed'>;

export interface MapOptions {
  signal: AbortSignal;
  onProgress: (progress: number) => void;
}

/** Generates tonal art maps for settings. Keeps the latest few, and the user's own. */
export class TonalArtMapCache {
  private static readonly kept = 6;
  private readonly maps = new Map<string, TonalArtMap>();
  private own: TonalArtMap | undefined;
  /** How long the latest map by a hand took to draw, in milliseconds. */
  handTime = 0;
  /** Numbers for the keys of hands. */
  private readonly hands = new WeakMap<Hand, number>();
  private handCount = 0;

  /** Keeps the user's own map, for the style `file`, and disposes the previous one. */
  keep(map: TonalArtMap): void {
    this.own?.dispose();
    this.own = map;
  }

  /**
   * Resolves at once for a map that is kept. The map in use must be passed as `inUse`, so that it is not disposed.
   *
   * @param hand that the map is drawn with, if the settings ask for one
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
    const map = known ?? (await generate({ ...drawingOf(settings, hand), ...options }));
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

  /** Whether the map is kept. */
  has(settings: MapSettings, hand?: Hand): boolean {
    return this.maps.has(this.keyOf(settings, hand));
  }

  private keyOf(settings: MapSettings, hand: Hand | undefined): string {
    if (hand && !this.hands.has(hand)) this.hands.set(hand, ++this.handCount);
    const { size, tones, seed } = drawingOf(settings, hand);
    return `${hand ? this.hands.get(hand) : styleOf(settings)} ${size} ${tones} ${seed}`;
  }

  /** Disposes of what all maps have on the graphics card, where those in use are uploaded again. */
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

const generate: typeof TonalArtMap.generate = async (options) =>
  (await import('./generateMap.js')).generateMap(options);
