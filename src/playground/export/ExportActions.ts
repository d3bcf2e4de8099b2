import type { GeometryLoader } from '../loading/bakeLoaders.js';
import { zipMap } from '../loading/mapFiles.js';
import type { PageAddress } from '../session/PageAddress.js';
import type { Session } from '../session/Session.js';
import type { Remedy, Status } from '../tasks/Status.js';
import { sentenceFor } from '../tasks/Status.js';
import type { TaskRunner } from '../tasks/TaskRunner.js';
import type { SaveDrawing } from './download.js';
import { copyText, download, fileStem } from './download.js';
import type { PlotPreview } from './PlotPreview.js';

/** A picture of a simplified model may deviate by this many pixels from the full model without a note. */
const MOST_PIXELS = 1 / 3;

/** The actions that export the drawing as a picture, video, archive or link, and the map. */
export class ExportActions {
  private plotPreview: PlotPreview | undefined;

  constructor(
    private readonly session: Session,
    private readonly address: PageAddress,
    private readonly status: Status,
    private readonly tasks: TaskRunner,
    private readonly geometries: Pick<GeometryLoader, 'settled'>,
  ) {}

  /** Saves the picture by the settings: one PNG, or its layers in an archive. */
  readonly savePng = async (): Promise<void> => {
    const again = { label: 'Save it again', run: this.savePng };
    const saved = await this.draw(async () => (await import('./savePicture.js')).savePicture, again);
    if (!saved) return;
    const { kind, size, pixelsPerRadius } = saved;
    const { simplified } = this.session.modelLoader.shown;
    const pixels = simplified ? pixelsPerRadius * simplified.error : 0;
    if (pixels <= MOST_PIXELS) this.status.say(`Saved as ${kind}: ${size}.`);
    else {
      const sentence = `Saved as ${kind}, simplified: up to ${pixels.toFixed(1)} px off.`;
      this.status.offer(sentence, { label: 'Save finer', run: this.saveFiner });
    }
  };

  /** Saves the picture from more triangles than the page draws. */
  private readonly saveFiner = (): Promise<void> => {
    const { files, variant, switched } = this.session.modelLoader.shown;
    return this.save(async () => (await import('./saveFiner.js')).saveFiner(files, { variant, switched }), {
      label: 'Save it again',
      run: this.saveFiner,
    });
  };

  /** Saves the drawing as vector lines, for print or a plotter. */
  readonly saveSvg = (): Promise<void> =>
    this.save(async () => (await import('./saveSvg.js')).saveSvg, { label: 'Save it again', run: this.saveSvg });

  /** Draws what a plotter would, and shows it path by path before it is saved. */
  readonly previewPlot = async (): Promise<void> => {
    const again = { label: 'Draw it again', run: this.previewPlot };
    const file = await this.draw(async () => (await import('./saveSvg.js')).drawLineFile, again);
    if (!file) return;
    const { PlotPreview } = await import('./PlotPreview.js');
    this.plotPreview ??= new PlotPreview((sentence) => this.status.say(sentence));
    this.plotPreview.open(file, this.session.settings.paper);
  };

  /** Records the video frame by frame, by the settings. */
  readonly saveVideo = (): Promise<void> =>
    this.save(async () => (await import('../video/saveVideo.js')).saveVideo, {
      label: 'Record it again',
      run: this.saveVideo,
    });

  /** Draws the picture by the settings as one PNG. @throws Error if that fails; the status line says why */
  readonly drawPicture = async (): Promise<Blob> => {
    const picture = await this.draw(async () => (await import('./savePicture.js')).drawForClipboard);
    if (!picture) throw new Error('There is no picture; the status line says why.');
    return picture;
  };

  private async save(fetchSave: () => Promise<SaveDrawing>, again: Remedy): Promise<void> {
    const sentence = await this.draw(fetchSave, again);
    if (sentence !== undefined) this.status.say(sentence);
  }

  /**
   * Runs the function that `fetchDraw` imports once everything has been baked. Only one picture is drawn at a time. Undefined if it fails.
   */
  private async draw<Result>(
    fetchDraw: () => Promise<SaveDrawing<Result>>,
    again?: Remedy,
  ): Promise<Result | undefined> {
    const { status } = this;
    const { viewport, modelLoader } = this.session;
    if (this.tasks.isRunning('picture')) return undefined;
    if (viewport.isLost) status.fail('There is nothing to save until the graphics card draws again.');
    else if (!viewport.isComplete) status.fail('There is no drawing to save yet.');
    else {
      let result: Result | undefined;
      const end = await this.tasks.run(
        'picture',
        async (report, signal) => {
          const [draw] = await Promise.all([fetchDraw(), this.geometries.settled(signal)]);
          signal.throwIfAborted();
          result = await draw(
            viewport,
            { ...this.session.settings },
            fileStem(modelLoader.shown.title),
            report,
            signal,
          );
        },
        again,
      );
      if (end === 'done') return result;
    }
    return undefined;
  }

  /** Saves the model, look and view in one archive, which the page can open. */
  readonly saveDrawing = async (): Promise<void> => {
    const { session, status } = this;
    const { modelLoader } = session;
    const { unpacked, files } = modelLoader.shown;
    if (!modelLoader.ownFiles) {
      status.say('This model is part of the page: a link to the drawing brings all of it back.');
      return;
    }
    const link = new URLSearchParams(session.link);
    // The archive contains the model itself.
    link.delete('model');
    try {
      const { zipDrawing } = await import('./zip.js');
      const drawing = {
        model: unpacked ?? files,
        strokes: session.ownStrokes ?? [],
        link: link.toString(),
      };
      download(await zipDrawing(drawing), `${fileStem(modelLoader.shown.title)}-drawing.zip`);
      status.say(
        'Saved as a ZIP: the model, its look, the view and the light. Dropped here, it is this drawing again.',
      );
    } catch (error) {
      status.fail(sentenceFor(error));
    }
  };

  readonly saveMap = async (): Promise<void> => {
    const { viewport, settings } = this.session;
    const map = viewport.tonalArtMap;
    if (!map) return;
    const { mapStyle } = settings;
    try {
      download(await zipMap(map), `${mapStyle === 'file' ? 'map' : mapStyle}.zip`);
      this.status.say('The map is saved as PNG images in a ZIP.');
    } catch (error) {
      this.status.fail(sentenceFor(error));
    }
  };

  /** Opens the system's share dialog with the link. Copies the link if that fails. */
  readonly share = async (): Promise<void> => {
    try {
      await navigator.share({ title: document.title, url: this.link });
      if (this.missing) this.status.say(`The link is on its way. ${this.missing}`);
    } catch (error) {
      // The user may have closed the dialog.
      if ((error as Error).name !== 'AbortError') await this.copyLink();
    }
  };

  readonly copyLink = async (): Promise<void> => {
    const isInAddress = this.address.write(this.session.link, this.address.drawing);
    const isCopied = await copyText(this.link);
    if (!isCopied && !isInAddress) {
      this.status.fail(
        'The browser lets this page neither use the clipboard nor write its address, so there is no link.',
      );
      return;
    }
    const where = isCopied ? 'The link is on the clipboard.' : "The link is in the browser's address line.";
    this.status.say(`${where} ${this.missing}`.trim());
  };

  /** Copies facts for a bug report on the page, the machine and the drawing. File names are left out. */
  readonly copyFacts = async (): Promise<void> => {
    const { session, status } = this;
    const { factsOf } = await import('./factsOf.js');
    const facts = factsOf(session);
    if (await copyText(facts)) status.say('The facts are on the clipboard, without the name of a file.');
    else {
      download(new Blob([facts], { type: 'text/plain' }), 'three-hatching-facts.txt');
      status.say('The browser does not let this page use the clipboard. The facts are saved as a file.');
    }
  };

  /** A sentence or two on what a link does not include. */
  private get missing(): string {
    const { isModelInLink, isHandInLink } = this.session;
    return [
      ...(isModelInLink ? [] : ['It cannot carry your own model.']),
      ...(isHandInLink ? [] : ['Your own hand is too long for it: save it as a file.']),
    ].join(' ');
  }

  private get link(): string {
    return new URL(`#${this.session.link}`, location.href).href;
  }
}
