import type { Hand, TonalArtMap } from 'three-hatching';
import { ModelError } from '../../../files/common/ModelError.js';
import type { ModelFile } from '../../../files/readModel.js';
import { SETTINGS, type Settings } from '../../../settings/settings.js';
import { drawsWithMap } from '../../../settings/settingValues.js';
import type { OwnHand } from '../../drawing/OwnHand.js';
import type { MapSettings, TonalArtMapCache } from '../../drawing/TonalArtMapCache.js';
import type { Stage } from '../../stage/Stage.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';

/** Where the last map by a hand took longer than this, in milliseconds, a small one is drawn first. */
const SOON = 500;
/** The size of a map that is there soon, and the number of its tones. */
const QUICK = { mapSize: '128', mapTones: 4 } as const;

/** Loads tonal art maps and draws with them. A map is generated from the settings or read from the user's files. */
export class MapLoader {
  /** The files from which the user's own map was read. */
  ownFiles: readonly ModelFile[] | undefined;
  /** The user's own hand, with which the style `ownHand` draws. */
  hand: OwnHand | undefined;
  /** How many tiles of the map in use stand for one, because they are smaller: so strokes are as large as they will be. */
  tileScale = 1;
  /** How long the latest map by a hand took, in milliseconds. */
  private handTime = 0;
  /** The cache is fetched with the first map, because engraved lines and dots are drawn without one. */
  private cache: TonalArtMapCache | undefined;
  /** The settings of the map in use. */
  private shown: MapSettings | undefined;

  constructor(
    private readonly stage: Stage,
    private readonly settings: Settings,
    private readonly tasks: TaskRunner,
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
      const chosen = { ...this.settings };
      const options = { signal, onProgress };
      const hand = chosen.mapStyle === 'ownHand' ? await this.readHand() : undefined;
      signal.throwIfAborted();
      if (chosen.mapStyle === 'ownHand' && !hand) {
        // There is a drawing all the same.
        const plain = { ...chosen, mapStyle: SETTINGS.mapStyle.default };
        if (!this.shown) this.use(await cache.get(plain, options, undefined), plain);
        throw new ModelError('The hand in this link is damaged: ask for the link again, or for the hand as a file.');
      }
      const tileScale = Number(chosen.mapSize) / Number(QUICK.mapSize);
      if (hand && this.handTime > SOON && tileScale > 1 && !cache.has(chosen, hand)) {
        const quick = await cache.get({ ...chosen, ...QUICK }, options, this.stage.tonalArtMap, hand);
        signal.throwIfAborted();
        this.use(quick, this.shown ?? chosen, tileScale);
      }
      const isKept = cache.has(chosen, hand);
      const start = performance.now();
      const map = await cache.get(chosen, options, this.stage.tonalArtMap, hand);
      if (hand && !isKept) this.handTime = performance.now() - start;
      if (!signal.aborted) this.use(map);
    });
    if (end !== 'failed' || !this.shown) return;
    Object.assign(this.settings, this.shown);
    this.onPutBack();
  }

  /** Draws with a map from files. @param isRestored whether the page goes back to the map, so that it is no change by the user */
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

  /** The label of the style of the map in use. */
  get shownStyle(): string {
    return SETTINGS.mapStyle.choices[(this.shown ?? this.settings).mapStyle];
  }

  /** Releases the textures of all maps. To be called while the graphics context is lost. */
  releaseGraphics(): void {
    this.cache?.releaseGraphics();
  }

  /** The hand that is drawn with. One from a link is read now; undefined if that is damaged. */
  private async readHand(): Promise<Hand | undefined> {
    const own = this.hand;
    if (!own || own.hand || own.link === undefined) return own?.hand;
    const { readHand } = await import('../../../settings/handLink.js');
    const hand = readHand(own.link);
    // Undo may have gone on meanwhile.
    if (this.hand === own) this.hand = hand && { ...own, hand, strokes: hand.strokes };
    return hand;
  }

  private async fetchCache(): Promise<TonalArtMapCache> {
    const { TonalArtMapCache } = await import('../../drawing/TonalArtMapCache.js');
    this.cache ??= new TonalArtMapCache();
    return this.cache;
  }

  private use(
    map: TonalArtMap,
    { mapStyle, mapSize, mapTones, mapSeed }: MapSettings = this.settings,
    tileScale = 1,
  ): void {
    this.shown = { mapStyle, mapSize, mapTones, mapSeed };
    this.tileScale = tileScale;
    this.stage.tonalArtMap = map;
    this.onMap();
  }
}
