import type { DrawingStore } from './DrawingStore.js';
import type { PageAddress } from './PageAddress.js';
import type { Session } from './Session.js';

const DELAY_MILLISECONDS = 400;

/**
 * Keeps the page's address up to date, so that a reload or a bookmark brings the drawing back, and has the browser keep the files of
 * the user's own.
 */
export class AddressWriter {
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly session: Session,
    private readonly address: PageAddress,
    private readonly keeper: DrawingStore,
    /** Asks for a thumbnail of the drawing. */
    private readonly wantPicture: () => void,
    /** Whether another drawing is being opened. */
    private readonly isOpening: () => boolean,
  ) {
    const update = (): void => this.update();
    session.listen({ applied: update, moved: update });
    // Changes of the last moment are written, too.
    addEventListener('pagehide', () => {
      if (this.timer !== undefined) this.write();
    });
  }

  /** Writes the address soon. To be called when the drawing, or what is being opened, has changed. */
  update(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.write(), DELAY_MILLISECONDS);
  }

  private write(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const { session, address } = this;
    const { modelLoader } = session;
    // The address waits for the model: until then, the page shows one drawing and its settings describe another.
    if (this.isOpening() || address.isFollowed || modelLoader.isLoading) return;
    const files = {
      model: session.settings.model === 'file' ? modelLoader.ownFiles : undefined,
      map: session.ownStrokes,
    };
    this.keeper.shown(files, modelLoader.title, session.link, session.viewport.view.ownPlace);
    if (files.model || files.map) this.wantPicture();
  }
}
