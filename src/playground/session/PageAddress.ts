/** The state of the page's entry in the browser's history. */
interface EntryState {
  /** The id of the kept drawing that the entry shows. */
  drawing?: string | undefined;
}

/** The address of the page and its entry in the browser's history, which bring back the drawing after a reload. */
export class PageAddress {
  /** The hash that the page has written or read last. */
  private known = location.hash;

  /** The id of the kept drawing that the entry asks for. */
  get drawing(): string | undefined {
    return (history.state as EntryState | null)?.drawing;
  }

  /** Whether the hash was changed by a link, of which the page has not been told yet. Such a hash must not be overwritten. */
  get isFollowed(): boolean {
    return location.hash !== this.known;
  }

  /** Reads the hash, which the page is going to show. */
  read(): string {
    this.known = location.hash;
    return this.known;
  }

  /**
   * Replaces the entry by one for the drawing that is shown.
   *
   * @returns whether the browser has allowed it: some limit how often a page may do so, some forbid it in frames
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
