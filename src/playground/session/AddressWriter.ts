import type { DrawingStore } from './DrawingStore.js';
import type { PageAddress } from './PageAddress.js';
import type { Session } from './Session.js';

const DELAY_MILLISECONDS = 400;

/**
 * Keeps the page's address up to date, so that a reload or a bookmark restores the drawing, and stores the user's own files in the browser.
 */
export class AddressWriter {
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly session: Session,
    private readonly address: PageAddress,
    private readonly keeper: DrawingStore,
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
    this.keeper.shown(files, modelLoader.title, session.link, session.viewport.view.ownPlace);
    if (files.model || files.map) this.wantPicture();
  }
}
