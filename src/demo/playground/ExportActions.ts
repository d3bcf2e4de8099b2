import type { Report } from '../drawing/Report.js';
import type { Settings } from '../settings/settings.js';
import type { HatchingScene } from '../stage/createScene.js';
import { LAYERS } from '../stage/layers.js';
import { copyText } from './copyText.js';
import { download } from './download.js';
import { fileStem } from './fileStem.js';
import type { ModelLoader } from './ModelLoader.js';
import { zipMap } from './mapFiles.js';
import { page } from './page.js';
import { raiseCurtain } from './raiseCurtain.js';
import type { Status } from './Status.js';
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
  ) {}

  /** Saves the picture that the settings ask for: one PNG, or its layers in an archive. */
  readonly savePng = async (): Promise<void> => {
    const { scene, status } = this;
    if (this.tasks.isRunning('picture')) return;
    if (scene.isLost) status.fail('There is nothing to save before the graphics card has taken up the drawing again.');
    else if (!scene.isComplete) status.fail('There is no drawing to save yet.');
    else {
      const settings = { ...this.settings };
      let sentence = '';
      const end = await this.tasks.run('picture', async (report, signal) => {
        sentence = await this.draw(settings, report, signal);
      });
      if (end === 'done') status.say(sentence);
    }
  };

  private async draw(settings: Settings, report: Report, signal: AbortSignal): Promise<string> {
    const { scene } = this;
    const name = fileStem(this.modelLoader.title);
    const { drawPicture, cutToDrawing, planPrint, zipBlobs, describePrint } = await import('../print/print.js');
    const { clientWidth: width, clientHeight: height } = page.viewport;
    const lower = raiseCurtain(scene);
    try {
      const whole = planPrint(settings, { width, height });
      scene.hold(Math.max(whole.width, whole.height));
      const plan = settings.pictureCrop === 'drawing' ? await cutToDrawing(scene, whole, signal) : whole;
      const progressOf = (part: number, parts: number) => (progress: number) =>
        report('drawing the picture', (part + progress) / parts);
      if (settings.pictureLayers === 'one') {
        const look = { ground: settings.pictureGround };
        download(await drawPicture(scene, plan, look, { signal, onProgress: progressOf(0, 1) }), `${name}.png`);
      } else {
        const files: { name: string; content: Blob }[] = [];
        for (const [i, layer] of LAYERS.entries()) {
          const options = { signal, onProgress: progressOf(i, LAYERS.length) };
          const content = await drawPicture(scene, plan, { ground: 'transparent', layer }, options);
          files.push({ name: `${name}-${i + 1}-${layer}.png`, content });
        }
        download(await zipBlobs(files), `${name}-layers.zip`);
      }
      return `Saved: ${describePrint(plan)}.`;
    } finally {
      scene.release();
      lower();
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
    const { link } = this;
    history.replaceState(history.state, '', link);
    const where = (await copyText(link))
      ? 'The link is on the clipboard.'
      : "The link is in the browser's address line.";
    this.status.say(this.isModelInLink ? where : `${where} It cannot carry your own model.`);
  };

  private get link(): string {
    return new URL(`#${this.currentLink()}`, location.href).href;
  }

  private get isModelInLink(): boolean {
    return this.settings.model !== 'file' || this.modelLoader.address !== undefined;
  }
}
