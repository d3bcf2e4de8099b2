import { page } from '../page/page.js';
import type { DrawingOpener } from '../session/DrawingOpener.js';
import type { DrawingStore } from '../session/DrawingStore.js';
import type { Session } from '../session/Session.js';
import type { LaterPart, LaterParts } from '../tasks/LaterParts.js';
import type { ContactSheet } from './ContactSheet.js';
import type { Gallery, KeysDialog, RecentDialog } from './smallDialogs.js';

/** The dialogs of the page. Their scripts are fetched when they are first opened. */
export class Dialogs {
  private readonly gallery: LaterPart<Gallery>;
  private readonly keys: LaterPart<KeysDialog>;
  private readonly recent: LaterPart<RecentDialog>;
  private readonly contactSheet: LaterPart<ContactSheet>;

  constructor(
    private readonly session: Session,
    store: DrawingStore,
    opener: DrawingOpener,
    parts: LaterParts,
  ) {
    this.gallery = parts.later(async () => {
      const { Gallery } = await import('./smallDialogs.js');
      return new Gallery(page.gallery, ({ link }) => session.useLink(link));
    });
    this.keys = parts.later(async () => {
      const { KeysDialog } = await import('./smallDialogs.js');
      return new KeysDialog();
    });
    this.recent = parts.later(async () => {
      const { RecentDialog } = await import('./smallDialogs.js');
      return new RecentDialog(store, (id) => void opener.openKept(id));
    });
    this.contactSheet = parts.later(async () => {
      const { ContactSheet } = await import('./ContactSheet.js');
      return new ContactSheet(page.contactSheet);
    });
    session.listen({
      mapShown: () => {
        if (this.contactSheet.present) this.fill(this.contactSheet.present);
      },
    });
  }

  openGallery(): void {
    this.gallery.use((gallery) => gallery.open());
  }

  openKeys(): void {
    this.keys.use((keys) => keys.open());
  }

  openRecent(): void {
    this.recent.use((recent) => recent.open());
  }

  /** Shows the images of the map, even if the present technique draws without one. */
  showMap(): void {
    this.contactSheet.use((sheet) => {
      this.fill(sheet);
      sheet.open();
    });
    void this.session.mapLoader.showChosen(true);
  }

  private fill(sheet: ContactSheet): void {
    const { viewport, mapLoader } = this.session;
    if (viewport.tonalArtMap) sheet.show(viewport.tonalArtMap, mapLoader.shownStyle);
  }
}
