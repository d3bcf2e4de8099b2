import { shownName } from '../../files/common/shownText.js';
import type { ModelFile } from '../../files/readModel.js';
import type { KeptDrawing, KeptDrawings, KeptFiles } from '../../kept/KeptDrawings.js';
import { newId } from '../../kept/newId.js';
import type { CameraView } from '../../settings/CameraView.js';
import type { Status } from '../tasks/Status.js';
import type { PageAddress } from './PageAddress.js';

const sizeOf = (files: readonly ModelFile[] = []): number => files.reduce((sum, { content }) => sum + content.size, 0);

/**
 * Keeps drawings that need files of the user's own, so that they survive a reload, Back and a crash. Which of them the page shows
 * is noted in its entry of the browser's history.
 */
export class Keeper {
  private fetched: Promise<KeptDrawings> | undefined;
  /** The files of the drawing that is shown. */
  private files: KeptFiles = {};
  private id: string | undefined;
  /** Writing one after the other, so that what comes later stays. */
  private queue: Promise<void> = Promise.resolve();
  private hasSaidWhy = false;
  private hasSaidNoAddress = false;

  constructor(
    private readonly address: PageAddress,
    private readonly status: Status,
    private readonly onChange: () => void,
  ) {}

  /** Fetched when it is first asked for: it is not needed for a first drawing. */
  private get drawings(): Promise<KeptDrawings> {
    this.fetched ??= import('../../kept/KeptDrawings.js').then(({ KeptDrawings }) => new KeptDrawings());
    return this.fetched;
  }

  /**
   * To be called when the drawing has changed. A drawing without own files is left to the page's address.
   *
   * @param link of its settings and its view
   */
  shown(files: KeptFiles, title: string, link: string, camera: CameraView | undefined): void {
    if (!files.model && !files.map) {
      this.id = undefined;
      this.files = {};
      this.note(link);
      return;
    }
    const isOther = files.model !== this.files.model || files.map !== this.files.map;
    if (this.id === undefined || files.model !== this.files.model) this.id = newId();
    this.files = files;
    this.note(link);
    const drawing = {
      id: this.id,
      title,
      at: Date.now(),
      bytes: sizeOf(files.model) + sizeOf(files.map),
      link,
      camera,
    };
    this.write(title, async () => {
      const drawings = await this.drawings;
      await (isOther ? drawings.keep(drawing, files) : drawings.update(drawing));
    });
  }

  /** Keeps a thumbnail of the drawing that is shown now, also if the page shows another one by the time the thumbnail is there. */
  pictured(pending: Promise<string>): void {
    const { id } = this;
    if (id === undefined) return;
    // Where it cannot be kept, neither could the drawing, and that was said.
    void pending.then((picture) => {
      this.queue = this.queue
        .then(() => this.drawings)
        .then((drawings) => drawings.update({ id, picture }))
        .catch(() => {});
    });
  }

  /**
   * Reads a kept drawing, which is going to be shown, unless it is aborted. Undefined if it is gone.
   *
   * @throws Error if the browser does not give it back
   */
  async open(id: string, signal: AbortSignal): Promise<{ drawing: KeptDrawing; files: KeptFiles } | undefined> {
    const found = await (await this.drawings).read(id);
    if (!found || signal.aborted) return undefined;
    this.id = id;
    this.files = found.files;
    return found;
  }

  /** The kept drawings, the latest first. None where the browser keeps nothing. */
  list(): Promise<KeptDrawing[]> {
    return this.queue
      .then(() => this.drawings)
      .then((drawings) => drawings.list())
      .catch(() => []);
  }

  async forget(ids: readonly string[]): Promise<void> {
    await this.queue;
    await this.drawings.then((drawings) => drawings.forget(...ids)).catch(() => {});
    if (this.id !== undefined && ids.includes(this.id)) this.address.write(location.hash.slice(1), undefined);
    this.onChange();
  }

  /** Notes in the page's address what is shown. */
  private note(link: string): void {
    if (this.address.write(link, this.id) || this.hasSaidNoAddress) return;
    this.hasSaidNoAddress = true;
    this.status.say('This browser does not let the page write its address: a reload does not bring the drawing back.');
  }

  private write(title: string, task: () => Promise<void>): void {
    this.queue = this.queue.then(task).then(this.onChange, (error: unknown) => {
      if (this.hasSaidWhy) return;
      this.hasSaidWhy = true;
      const isFull = (error as Error | null)?.name === 'QuotaExceededError';
      this.status.say(
        isFull
          ? `${shownName(title)} is larger than what this browser keeps for a page: after a reload, open it again.`
          : `This browser keeps nothing here, as in a private window: after a reload, open ${shownName(title)} again.`,
      );
    });
  }
}
