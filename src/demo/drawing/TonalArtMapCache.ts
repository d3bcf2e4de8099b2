import type { TonalArtMap } from 'three-hatching';
import { SETTINGS, type Settings } from '../../settings/settings.js';

interface MapOptions {
  signal: AbortSignal;
  onProgress: (progress: number) => void;
}

/** Generates tonal art maps for settings. Keeps the latest few, and the user's own. */
export class TonalArtMapCache {
  private static readonly kept = 6;
  private readonly maps = new Map<string, TonalArtMap>();
  private own: TonalArtMap | undefined;

  /** Keeps the user's own map, for the style `file`, and disposes the previous one. */
  keep(map: TonalArtMap): void {
    this.own?.dispose();
    this.own = map;
  }

  /** Resolves at once for a map that is kept. The map in use must be passed as `inUse`, so that it is not disposed. */
  async get(settings: Settings, options: MapOptions, inUse: TonalArtMap | undefined): Promise<TonalArtMap> {
    const { mapSeed: seed, mapTones: tones } = settings;
    if (settings.mapStyle === 'file' && this.own) return this.own;
    const style = settings.mapStyle === 'file' ? SETTINGS.mapStyle.default : settings.mapStyle;
    const size = Number(settings.mapSize);
    const key = `${style} ${size} ${tones} ${seed}`;
    const map = this.maps.get(key) ?? (await generate({ style, size, tones, seed, ...options }));
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

  /** Disposes of what all maps have on the graphics card, where those in use are uploaded again. */
  releaseGraphics(): void {
    for (const map of this.maps.values()) map.dispose();
    this.own?.dispose();
  }
}

const generate: typeof TonalArtMap.generate = async (options) =>
  (await import('./generateMap.js')).generateMap(options);
