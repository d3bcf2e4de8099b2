import { shownName } from '../../viewer/files/common/shownText.js';
import type { ModelFile } from '../../viewer/files/readModel.js';
import type { CameraView } from '../../viewer/settings/CameraView.js';
import type { KeptDrawing, KeptDrawings, KeptFiles } from '../storage/KeptDrawings.js';
import { newId } from '../storage/newId.js';
import type { Status } from '../tasks/Status.js';
import type { PageAddress } from './PageAddress.js';

const sizeOf = (files: readonly ModelFile[] = []): number => files.reduce((sum, { content }) => sum + content.size, 0);

/**
 * Has the browser keep drawings that need files of the user's own, so that they survive a reload, the Back button and a crash. The entry
 * of the browser's history says which of them the page shows.
 */
export class DrawingStore {
  private fetched: Promise<KeptDrawings> | undefined;
  /** The files of the drawing that is shown. */
  private files: KeptFiles = {};
  private id: string | undefined;
  /** Writes are queued, so that the latest one wins. */
  private queue: Promise<void> = Promise.resolve();
  private hasSaidWhy = false;
  private hasSaidNoAddress = false;

  constructor(
    private readonly address: PageAddress,
    private readonly status: Status,
    private readonly onChange: () => void,
  ) {}

  /** The script is fetched when it is first needed, which is after the first drawing. */
  private get drawings(): Promise<KeptDrawings> {
    this.fetched ??= import('../storage/KeptDrawings.js').then(({ KeptDrawings }) => new KeptDrawings());
    return this.fetched;
  }

  /**
   * To be called when the drawing has changed. For a drawing without files of the user's own, the page's address is enough.
   *
   * @param link the settings and the camera, as the text of a link
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
    // If this fails, writing the drawing has failed as well, and the user was told.
    void pending.then((picture) => {
      this.queue = this.queue
        .then(() => this.drawings)
        .then((drawings) => drawings.update({ id, picture }))
        .catch(() => {});
    });
  }

  /**
   * Reads a kept drawing, which is the shown one from now on. Undefined if it was deleted or `signal` is aborted.
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

  /** The kept drawings, the latest first. The list is empty if the browser keeps nothing. */
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

  /** Writes into the page's address what is shown. */
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
          ? `${shownName(title)} is larger than what this browser stores for a page: after a reload, open it again.`
          : `This browser stores nothing for this page, as in a private window: after a reload, open ${shownName(title)} again.`,
      );
    });
  }
}
