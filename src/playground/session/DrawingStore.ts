import { shownName } from '../../viewer/files/common/ModelError.js';
import type { ModelFile } from '../../viewer/files/readModel.js';
import type { CameraView } from '../../viewer/settings/CameraView.js';
import type { Status } from '../tasks/Status.js';
import type { KeptDrawing, KeptDrawings, KeptFiles } from './KeptDrawings.js';
import type { PageAddress } from './PageAddress.js';
import type { Session } from './Session.js';

const sizeOf = (files: readonly ModelFile[] = []): number => files.reduce((sum, { content }) => sum + content.size, 0);

/**
 * Stores drawings with the user's own files in the browser, so that they survive a reload, the Back button and a crash. The history entry
 * names the stored drawing.
 */
export class DrawingStore {
  private fetched: Promise<KeptDrawings> | undefined;
  /** The files of the shown drawing. */
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
    this.fetched ??= import('./KeptDrawings.js').then(({ KeptDrawings }) => new KeptDrawings());
    return this.fetched;
  }

  /**
   * Call this when the drawing has changed. A drawing without the user's own files needs no storage besides the page's address.
   *
   * @param link settings and camera, as the text of a link
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

  /** Stores a thumbnail of the present drawing, even if the page shows another one by the time the thumbnail is ready. */
  pictured(pending: Promise<string>): void {
    const { id } = this;
    if (id === undefined) return;
    // If this fails, storing the drawing has failed too, and the user was told.
    void pending.then((picture) => {
      this.queue = this.queue
        .then(() => this.drawings)
        .then((drawings) => drawings.update({ id, picture }))
        .catch(() => {});
    });
  }

  /**
   * Reads a stored drawing, which then is the shown one. Undefined if it was deleted or `signal` is aborted.
   *
   * @throws Error if the browser cannot read it
   */
  async open(id: string, signal: AbortSignal): Promise<{ drawing: KeptDrawing; files: KeptFiles } | undefined> {
    const found = await (await this.drawings).read(id);
    if (!found || signal.aborted) return undefined;
    this.id = id;
    this.files = found.files;
    return found;
  }

  /** The stored drawings, latest first; empty if the browser stores nothing. */
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

  /** Writes the shown drawing to the page's address. */
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

/** A random unique id. `crypto.randomUUID` is missing in pages that are not served over HTTPS. */
export const newId = (): string =>
  [...crypto.getRandomValues(new Uint32Array(4))].map((part) => part.toString(36)).join('-');

const DELAY_MILLISECONDS = 400;

/**
 * Keeps the page's address up to date, so that a reload or a bookmark restores the drawing, and stores the user's own files in the browser.
 */
export class AddressWriter {
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly session: Session,
    private readonly address: PageAddress,
    private readonly store: DrawingStore,
    /** Requests a thumbnail of the drawing. */
    private readonly wantPicture: () => void,
    /** Whether another drawing is being opened. */
    private readonly isOpening: () => boolean,
  ) {
    const update = (): void => this.update();
    session.listen({ applied: update, moved: update });
    // Writes changes of the last moment, too.
    addEventListener('pagehide', () => {
      if (this.timer !== undefined) this.write();
    });
  }

  /** Schedules writing the address. Call this when the drawing, or what is being opened, has changed. */
  update(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.write(), DELAY_MILLISECONDS);
  }

  private write(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const { session, address } = this;
    const { modelLoader } = session;
    // While a model loads, the page still shows the previous drawing, so the address waits.
    if (this.isOpening() || address.isFollowed || modelLoader.isLoading) return;
    const files = {
      model: session.settings.model === 'file' ? modelLoader.ownFiles : undefined,
      map: session.ownStrokes,
    };
    this.store.shown(files, modelLoader.shown.title, session.link, session.viewport.view.ownPlace);
    if (files.model || files.map) this.wantPicture();
  }
}
