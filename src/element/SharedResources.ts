/** Something that several users share, and how many do. */
interface Shared<Resource> {
  resource: Promise<Resource>;
  users: number;
}

/** Resources that are made once for all who use them at the same time, and freed when the last user gives them back. */
export class SharedResources<Key, Resource extends { dispose(): void }> {
  private readonly shared = new Map<Key, Shared<Resource>>();

  /**
   * The resource of a key. It is to be given back, also where making it failed.
   *
   * @param make is called if nobody uses the resource
   */
  borrow(key: Key, make: () => Promise<Resource>): Promise<Resource> {
    let entry = this.shared.get(key);
    if (!entry) {
      entry = { resource: make(), users: 0 };
      this.shared.set(key, entry);
    }
    entry.users++;
    return entry.resource;
  }

  /** Frees the resource of a key when its last user gives it back. */
  giveBack(key: Key): void {
    const entry = this.shared.get(key);
    if (!entry || --entry.users > 0) return;
    this.shared.delete(key);
    entry.resource.then(
      (resource) => resource.dispose(),
      () => {
        // Whoever borrowed it was told that it failed.
      },
    );
  }
}
