/** What the page's entry in the browser's history remembers. */
interface EntryState {
  /** The kept drawing that it shows. */
  drawing?: string | undefined;
}

/** The address of the page and its entry in the browser's history, which bring back the drawing after a reload. */
export class PageAddress {
  /** The hash that was written or read last. */
  private known = location.hash;

  /** The kept drawing that the entry asks for. */
  get drawing(): string | undefined {
    return (history.state as EntryState | null)?.drawing;
  }

  /** Whether somebody has followed a link of which the page has not been told yet. It must not be written over. */
  get isFollowed(): boolean {
    return location.hash !== this.known;
  }

  /** The hash, which the page is going to show. */
  read(): string {
    this.known = location.hash;
    return this.known;
  }

  /**
   * Notes what is shown, in place of what the page has shown before.
   *
   * @returns whether the browser has let it: some count how often a page does so, some forbid it to pages within others
   */
  write(link: string, drawing: string | undefined): boolean {
    try {
      history.replaceState(drawing === undefined ? null : ({ drawing } satisfies EntryState), '', `#${link}`);
    } catch {
      return false;
    }
    this.known = location.hash;
    return true;
  }
}
