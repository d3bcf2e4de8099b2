import type { Settings } from '../settings/settings.js';
import type { HatchingScene } from '../stage/createScene.js';
import { copyText } from './copyText.js';
import { download } from './download.js';
import { fileStem } from './fileStem.js';
import type { ModelLoader } from './ModelLoader.js';
import { zipMap } from './mapFiles.js';
import type { PageAddress } from './PageAddress.js';
import type { SaveDrawing } from './SaveDrawing.js';
import type { Remedy, Status } from './Status.js';
import { sentenceFor } from './sentenceFor.js';
import type { TaskRunner } from './TaskRunner.js';

/** The actions that export a drawing: as a picture, as a link, as code; and the map it is drawn with. */
export class ExportActions {
  constructor(
    private readonly scene: HatchingScene,
    private readonly settings: Settings,
    private readonly modelLoader: ModelLoader,
    private readonly status: Status,
    private readonly tasks: TaskRunner,
    private readonly currentLink: () => string,
    private readonly address: PageAddress,
  ) {}

  /** Saves the picture that the settings ask for: one PNG, or its layers in an archive. */
  readonly savePng = (): Promise<void> =>
    this.save(async () => (await import('./savePicture.js')).savePicture, {
      label: 'Save it again',
      run: this.savePng,
    });

  /** Records the video that the settings ask for, frame by frame. */
  readonly saveVideo = (): Promise<void> =>
    this.save(async () => (await import('./saveVideo.js')).saveVideo, {
      label: 'Record it again',
      run: this.saveVideo,
    });

  /** Draws and saves by what `fetchSave` fetches. Nothing else is saved meanwhile. */
  private async save(fetchSave: () => Promise<SaveDrawing>, again: Remedy): Promise<void> {
    const { scene, status } = this;
    if (this.tasks.isRunning('picture')) return;
    if (scene.isLost) status.fail('There is nothing to save before the graphics card has taken up the drawing again.');
    else if (!scene.isComplete) status.fail('There is no drawing to save yet.');
    else {
      const settings = { ...this.settings };
      let sentence = '';
      const end = await this.tasks.run(
        'picture',
        async (report, signal) => {
          const save = await fetchSave();
          signal.throwIfAborted();
          sentence = await save(scene, settings, fileStem(this.modelLoader.title), report, signal);
        },
        again,
      );
      if (end === 'done') status.say(sentence);
    }
  }

  readonly saveMap = async (): Promise<void> => {
    const map = this.scene.tonalArtMap;
    if (!map) return;
    const { mapStyle } = this.settings;
    try {
      download(await zipMap(map), `${mapStyle === 'file' ? 'map' : mapStyle}.zip`);
      this.status.say('The map is saved.');
    } catch (error) {
      this.status.fail(sentenceFor(error));
    }
  };

  /** Hands the link to the system's sheet for sharing. */
  readonly share = async (): Promise<void> => {
    try {
      await navigator.share({ title: document.title, url: this.link });
      if (!this.isModelInLink) this.status.say('The link is on its way. It cannot carry your own model.');
    } catch (error) {
      // Closing the sheet is an answer, too.
      if ((error as Error).name !== 'AbortError') await this.copyLink();
    }
  };

  readonly copyLink = async (): Promise<void> => {
    const isInAddress = this.address.write(this.currentLink(), this.address.drawing);
    const isCopied = await copyText(this.link);
    if (!isCopied && !isInAddress) {
      this.status.fail(
        'The browser lets this page neither use the clipboard nor write its address, so there is no link.',
      );
      return;
    }
    const where = isCopied ? 'The link is on the clipboard.' : "The link is in the browser's address line.";
    this.status.say(this.isModelInLink ? where : `${where} It cannot carry your own model.`);
  };

  private get link(): string {
    return new URL(`#${this.currentLink()}`, location.href).href;
  }

  private get isModelInLink(): boolean {
    return this.settings.model !== 'file' || this.modelLoader.address !== undefined;
  }
}
