import type { TonalArtMap } from 'three-hatching';
import type { TonalArtMapCache } from '../../drawing/TonalArtMapCache.js';
import type { ModelFile } from '../../files/readModel.js';
import { SETTINGS, type Settings } from '../../settings/settings.js';
import { drawsWithMap } from '../../settings/settingValues.js';
import type { Stage } from '../../stage/Stage.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';

type MapSettings = Pick<Settings, 'mapStyle' | 'mapSize' | 'mapTones' | 'mapSeed'>;

/** Loads tonal art maps and draws with them: generated from the settings, or read from the user's files. */
export class MapLoader {
  /** What the user's own map was read from. */
  ownFiles: readonly ModelFile[] | undefined;
  /** Fetched with the first map: engraved lines and dots are drawn without. */
  private cache: TonalArtMapCache | undefined;
  /** The settings of the map that is drawn with. */
  private shown: MapSettings | undefined;

  constructor(
    private readonly stage: Stage,
    private readonly settings: Settings,
    private readonly tasks: TaskRunner,
    /** Called when another map is drawn with. */
    private readonly onMap: () => void,
    /** Called when the user's own map has become the style in the settings. */
    private readonly onOwnMap: (isRestored: boolean) => void,
    /** Called when the settings of the map in use were put back. */
    private readonly onPutBack: () => void,
  ) {}

  /**
   * Draws with the map that the settings ask for. If that fails or is cancelled, they are put back to those of the map in use.
   *
   * @param isWanted also if nothing is drawn with it: it is to be looked at
   */
  async showChosen(isWanted = drawsWithMap(this.settings)): Promise<void> {
    if (!isWanted) return;
    const end = await this.tasks.run('map', async (report, signal) => {
      const onProgress = (progress: number): void => report('drawing strokes for the map', progress);
      const cache = await this.fetchCache();
      signal.throwIfAborted();
      const map = await cache.get(this.settings, { signal, onProgress }, this.stage.tonalArtMap);
      if (!signal.aborted) this.use(map);
    });
    if (end !== 'failed' || !this.shown) return;
    Object.assign(this.settings, this.shown);
    this.onPutBack();
  }

  /** Draws with a map read from files. @param isRestored whether it was drawn with before */
  async showFiles(files: readonly ModelFile[], isRestored = false): Promise<void> {
    await this.tasks.run('map', async (report, signal) => {
      const onProgress = (progress: number): void => report('reading your images', progress);
      const { loadMapFiles } = await import('./mapFiles.js');
      const cache = await this.fetchCache();
      signal.throwIfAborted();
      const map = await loadMapFiles(files, { signal, onProgress });
      signal.throwIfAborted();
      this.settings.mapStyle = 'file';
      this.ownFiles = files;
      this.use(map);
      cache.keep(map);
      this.onOwnMap(isRestored);
    });
  }

  /** The label of the style of the map that is drawn with. */
  get shownStyle(): string {
    return SETTINGS.mapStyle.choices[(this.shown ?? this.settings).mapStyle];
  }

  /** To be called while the graphics context is lost. */
  releaseGraphics(): void {
    this.cache?.releaseGraphics();
  }

  private async fetchCache(): Promise<TonalArtMapCache> {
    const { TonalArtMapCache } = await import('../../drawing/TonalArtMapCache.js');
    this.cache ??= new TonalArtMapCache();
    return this.cache;
  }

  private use(map: TonalArtMap): void {
    const { mapStyle, mapSize, mapTones, mapSeed } = this.settings;
    this.shown = { mapStyle, mapSize, mapTones, mapSeed };
    this.stage.tonalArtMap = map;
    this.onMap();
  }
}
