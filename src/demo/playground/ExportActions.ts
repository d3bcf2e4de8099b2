import type { Settings } from '../settings/settings.js';
import type { HatchingScene } from '../stage/createScene.js';
import { codeSample } from './codeSample.js';
import { copyText } from './copyText.js';
import { download } from './download.js';
import { exportPng } from './exportPng.js';
import type { ModelLoader } from './ModelLoader.js';
import { page } from './page.js';
import type { Status } from './Status.js';

/** What a person can take along: the picture, a link to it, the code for its look. */
export class ExportActions {
  constructor(
    private readonly scene: HatchingScene,
    private readonly settings: Settings,
    private readonly models: ModelLoader,
    private readonly status: Status,
    private readonly currentLink: () => string,
  ) {}

  readonly savePng = async (): Promise<void> => {
    const { settings, status } = this;
    const name = this.models.title
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
      status.fail(error instanceof Error ? error.message : String(error));
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
    // What the page makes itself cannot be loaded elsewhere.
    const radius = this.settings.model === 'file' ? this.models.sceneRadius : undefined;
    if (await copyText(codeSample(this.settings, radius))) this.status.say('The code is on the clipboard.');
    else this.status.fail('The browser does not let this page use the clipboard.');
  };
}
