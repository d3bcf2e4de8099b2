import type { TonalArtMap } from 'three-hatching';
import type { ModelFile } from '../../viewer/files/readModel.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { drawsWithMap } from '../../viewer/settings/settingValues.js';
import type { OwnHand } from '../maps/OwnHand.js';
import type { MapSettings, TonalArtMapCache } from '../maps/TonalArtMapCache.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import type { Viewport } from '../viewport/Viewport.js';

/** Loads tonal art maps and draws with them. A map is generated from the settings or read from the user's files. */
export class MapLoader {
  /** The files from which the user's own map was read. */
  ownFiles: readonly ModelFile[] | undefined;
  /** The user's own hand, with which the style `ownHand` draws. */
  hand: OwnHand | undefined;
  /** How many tiles of the map in use stand for one, because they are smaller: so strokes are as large as they will be. */
  tileScale = 1;
  /** The cache is fetched with the first map, because engraved lines and dots are drawn without one. */
  private cache: TonalArtMapCache | undefined;
  /** The settings of the map in use. */
  private shown: MapSettings | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly viewport: Viewport,
    readonly settings: Settings,
    readonly tasks: TaskRunner,
    /** Called when another map is in use. */
    private readonly onMap: () => void,
    /** Called when the settings have been set to the user's own map. */
    private readonly onOwnMap: (isRestored: boolean) => void,
    /** Called when the settings have been set back to those of the map in use. */
    private readonly onPutBack: () => void,
  ) {}

  /**
   * Draws with the map that the settings ask for. If that fails or is cancelled, the settings are set back to those of the map in
   * use.
   *
   * @param isWanted whether the map is needed: for the drawing, or because the user wants to look at it
   */
  async showChosen(isWanted = drawsWithMap(this.settings)): Promise<void> {
    if (!isWanted) return;
    const end = await this.tasks.run('map', async (report, signal) => {
      const onProgress = (progress: number): void => report('drawing strokes for the map', progress);
      const cache = await this.fetchCache();
      signal.throwIfAborted();
      const options = { signal, onProgress };
      if (this.settings.mapStyle === 'ownHand') {
        const { showHandMap } = await import('./showHandMap.js');
        signal.throwIfAborted();
        await showHandMap(cache, { ...this.settings }, options, this);
        return;
      }
      const map = await cache.get(this.settings, options, this.map);
      if (!signal.aborted) this.use(map);
    });
    if (end !== 'failed' || !this.shown) return;
    Object.assign(this.settings, this.shown);
    this.onPutBack();
  }

  /** Draws with the map that the settings ask for by the end of a pause, which begins anew with each call. @param pause in milliseconds */
  showChosenAfter(pause: number): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      this.timer = undefined;
      void this.showChosen();
    }, pause);
  }

  /** Whether a map will be drawn after a pause. */
  get isAwaited(): boolean {
    return this.timer !== undefined;
  }

  /** Draws with a map or a hand from files. @param isRestored whether the page goes back to the map, so that it is no change by the user */
  async showFiles(files: readonly ModelFile[], isRestored = false): Promise<void> {
    await this.tasks.run('map', async (report, signal) => {
      const onProgress = (progress: number): void => report('reading your images', progress);
      const { loadMapFiles, showHandFile } = await import('./mapFiles.js');
      const cache = await this.fetchCache();
      signal.throwIfAborted();
      const options = { signal, onProgress };
      if (!(await showHandFile(files, cache, options, this))) {
        const map = await loadMapFiles(files, options);
        signal.throwIfAborted();
        this.settings.mapStyle = 'file';
        this.ownFiles = files;
        this.use(map);
        cache.keep(map);
      }
      this.onOwnMap(isRestored);
    });
  }

  /** The label of the style of the map in use. */
  get shownStyle(): string {
    return SETTINGS.mapStyle.choices[(this.shown ?? this.settings).mapStyle];
  }

  /** Releases the textures of all maps. To be called while the graphics context is lost. */
  releaseGraphics(): void {
    this.cache?.releaseGraphics();
  }

  private async fetchCache(): Promise<TonalArtMapCache> {
    const { TonalArtMapCache } = await import('../maps/TonalArtMapCache.js');
    this.cache ??= new TonalArtMapCache();
    return this.cache;
  }

  /** The map in use. */
  get map(): TonalArtMap | undefined {
    return this.viewport.tonalArtMap;
  }

  /**
   * @param settings that say which map it is
   * @param tileScale how many of its tiles stand for one
   */
  use(map: TonalArtMap, { mapStyle, mapSize, mapTones, mapSeed }: MapSettings = this.settings, tileScale = 1): void {
    this.shown = { mapStyle, mapSize, mapTones, mapSeed };
    this.tileScale = tileScale;
    this.viewport.tonalArtMap = map;
    this.onMap();
  }
}
