import type { TonalArtMap } from 'three-hatching';
import { TonalArtMapCache } from '../drawing/TonalArtMapCache.js';
import type { ModelFile } from '../files/readModel.js';
import { SETTINGS, type Settings } from '../settings/settings.js';
import { needsMap } from '../settings/settingValues.js';
import type { HatchingScene } from '../stage/createScene.js';
import type { ContactSheet } from './ContactSheet.js';
import { loadMapFiles } from './mapFiles.js';
import type { TaskRunner } from './TaskRunner.js';

/** Loads tonal art maps and draws with them: generated from the settings, or read from the user's files. */
export class MapLoader {
  private readonly cache = new TonalArtMapCache();

  constructor(
    private readonly scene: HatchingScene,
    private readonly settings: Settings,
    private readonly tasks: TaskRunner,
    private readonly contactSheet: ContactSheet,
    /** Called when the user's own map has become the style in the settings. */
    private readonly onOwnMap: () => void,
  ) {}

  /** Draws with the map that the settings ask for. @param isWanted also if nothing is drawn with it: it is to be looked at */
  async showChosen(isWanted = needsMap(this.settings)): Promise<void> {
    if (!isWanted) return;
    await this.tasks.run('map', async (report, signal) => {
      const onProgress = (progress: number): void => report('drawing strokes for the map', progress);
      const map = await this.cache.get(this.settings, { signal, onProgress }, this.scene.tonalArtMap);
      if (!signal.aborted) this.use(map);
    });
  }

  /** Draws with a map read from files. */
  async showFiles(files: readonly ModelFile[]): Promise<void> {
    await this.tasks.run('map', async (report, signal) => {
      const onProgress = (progress: number): void => report('reading your images', progress);
      const map = await loadMapFiles(files, { signal, onProgress });
      signal.throwIfAborted();
      this.settings.mapStyle = 'file';
      this.use(map);
      this.cache.keep(map);
      this.onOwnMap();
    });
  }

  /** To be called while the graphics context is lost. */
  releaseGraphics(): void {
    this.cache.releaseGraphics();
  }

  private use(map: TonalArtMap): void {
    this.scene.setTonalArtMap(map);
    this.contactSheet.show(map, SETTINGS.mapStyle.choices[this.settings.mapStyle]);
  }
}
