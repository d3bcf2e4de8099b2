import type { TonalArtMap } from 'three-hatching';
import type { ModelFile } from '../../viewer/files/readModel.js';
import { SETTINGS, type Settings } from '../../viewer/settings/settings.js';
import { drawsWithMap } from '../../viewer/settings/settingValues.js';
import type { OwnHand } from '../session/DrawingState.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import type { Viewport } from '../viewport/Viewport.js';
import type { MapSettings, TonalArtMapCache } from './TonalArtMapCache.js';

/** Loads tonal art maps and draws with them. A map is generated from the settings or read from the user's files. */
export class MapLoader {
  /** The files of the user's own map. */
  ownFiles: readonly ModelFile[] | undefined;
  /** The user's own hand, for the style `ownHand`. */
  hand: OwnHand | undefined;
  /** Scale of the present map: above 1 for a small preview, whose strokes then have their final size. */
  tileScale = 1;
  /** Fetched with the first map, because lines and dots need none. */
  private cache: TonalArtMapCache | undefined;
  /** The settings of the present map. */
  private shown: MapSettings | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly viewport: Viewport,
    readonly settings: Settings,
    readonly tasks: TaskRunner,
    /** Called when another map is in use. */
    private readonly onMap: () => void,
    /** Called when the settings have been changed to the user's own map. */
    private readonly onOwnMap: (isRestored: boolean) => void,
    /** Called when the settings have been reset to the present map. */
    private readonly onPutBack: () => void,
  ) {}

  /**
   * Draws with the map of the settings. If that fails or is cancelled, the settings are reset to the present map.
   *
   * @param isWanted whether the map is needed, for the drawing or for the contact sheet
   */
  async showChosen(isWanted = drawsWithMap(this.settings)): Promise<void> {
    if (!isWanted) return;
    const end = await this.tasks.run('map', async (report, signal) => {
      const onProgress = (progress: number): void => report('drawing strokes for the map', progress);
      const cache = await this.fetchCache();
      signal.throwIfAborted();
      const options = { signal, onProgress };
      if (this.settings.mapStyle === 'ownHand') {
        const { showHandMap } = await import('./mapFiles.js');
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

  /** Calls {@link showChosen} after a pause, which restarts with each call. @param pause in milliseconds */
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

  /**
   * Draws with a map or a hand from files. @param isRestored whether the page returns to the map, so that this is not a change by the user
   */
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

  /** Label of the present map's style. */
  get shownStyle(): string {
    return SETTINGS.mapStyle.choices[(this.shown ?? this.settings).mapStyle];
  }

  /** Releases the textures of all maps. Call this while the graphics context is lost. */
  releaseGraphics(): void {
    this.cache?.releaseGraphics();
  }

  private async fetchCache(): Promise<TonalArtMapCache> {
    const { TonalArtMapCache } = await import('./TonalArtMapCache.js');
    this.cache ??= new TonalArtMapCache();
    return this.cache;
  }

  /** The present map. */
  get map(): TonalArtMap | undefined {
    return this.viewport.tonalArtMap;
  }

  /**
   * @param settings of the map
   * @param tileScale factor on its tiles, above 1 for a preview
   */
  use(map: TonalArtMap, { mapStyle, mapSize, mapTones, mapSeed }: MapSettings = this.settings, tileScale = 1): void {
    this.shown = { mapStyle, mapSize, mapTones, mapSeed };
    this.tileScale = tileScale;
    this.viewport.tonalArtMap = map;
    this.onMap();
  }
}
