import { errorMessage } from '../files/errorMessage.js';
import type { Settings } from '../settings/settings.js';
import type { HatchingScene } from '../stage/createScene.js';
import { codeSample } from './codeSample.js';
import { copyText } from './copyText.js';
import { download } from './download.js';
import { exportPng } from './exportPng.js';
import type { ModelLoader } from './ModelLoader.js';
import { zipMap } from './mapFiles.js';
import { page } from './page.js';
import type { Status } from './Status.js';
import { sentenceFor } from './sentenceFor.js';

/** The actions that export a drawing: as a picture, as a link, as code; and the map it is drawn with. */
export class ExportActions {
  constructor(
    private readonly scene: HatchingScene,
    private readonly settings: Settings,
    private readonly modelLoader: ModelLoader,
    private readonly status: Status,
    private readonly currentLink: () => string,
  ) {}

  readonly savePng = async (): Promise<void> => {
    const { settings, status } = this;
    const name = this.modelLoader.title
      .replace(/\.\w+$/, '')
      .replace(/\W+/g, '-')
      .toLowerCase();
    try {
      const picture = await exportPng(this.scene, {
        width: page.viewport.clientWidth,
        height: page.viewport.clientHeight,
        scale: Number(settings.pictureSize),
        ground: settings.pictureGround,
      });
      download(picture, `${name || 'drawing'}.png`);
      status.say('The picture is saved.');
    } catch (error) {
      status.fail(errorMessage(error));
    }
  };

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

  readonly copyLink = async (): Promise<void> => {
    const link = new URL(`#${this.currentLink()}`, location.href).href;
    history.replaceState(null, '', link);
    const where = (await copyText(link))
      ? 'The link is on the clipboard.'
      : "The link is in the browser's address line.";
    this.status.say(this.settings.model === 'file' ? `${where} It cannot carry your own model.` : where);
  };

  readonly copyCode = async (): Promise<void> => {
    // Only a user's own model is a file that the sample can load. Built-in scenes are made by the page.
    const radius = this.settings.model === 'file' ? this.modelLoader.sceneRadius : undefined;
    if (await copyText(codeSample(this.settings, radius))) this.status.say('The code is on the clipboard.');
    else this.status.fail('The browser does not let this page use the clipboard.');
  };
}
