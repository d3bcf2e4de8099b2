/** The state object of the page's history entry. */
interface EntryState {
  /** The id of the stored drawing of the entry. */
  drawing?: string | undefined;
}

/** The page's address and history entry, which restore the drawing after a reload. */
export class PageAddress {
  /** The hash that the page has written or read last. */
  private known = location.hash;

  /** The id of the stored drawing of the present entry. */
  get drawing(): string | undefined {
    return (history.state as EntryState | null)?.drawing;
  }

  /** Whether a link has changed the hash and the page has not read it yet. Such a hash must not be overwritten. */
  get isFollowed(): boolean {
    return location.hash !== this.known;
  }

  /** Reads the hash, which the page is about to show. */
  read(): string {
    this.known = location.hash;
    return this.known;
  }

  /**
   * Replaces the history entry by one for the shown drawing.
   *
   * @returns whether the browser allowed it: some limit the rate, some forbid it in frames
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
