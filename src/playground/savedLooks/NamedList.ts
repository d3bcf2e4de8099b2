/** A look or a view named by the user. */
export interface NamedItem {
  name: string;
  /** A thumbnail, as a data URL. */
  picture?: string | undefined;
  /** The key that chooses the item. */
  key?: string;
}

/** A list of named items. Methods that change it may return a sentence for the user. */
export interface NamedList {
  readonly items: readonly NamedItem[];
  readonly isFull: boolean;
  /** An unused name. */
  readonly freeName: string;
  /** Adds the present look or view. */
  add(name: string): string | undefined;
  choose(index: number): void;
  rename(index: number, name: string): string | undefined;
  remove(index: number): string | undefined;
  /** Whether the drawing shows the item. */
  isShown(index: number): boolean;
}

/** The first free name of the form `Look 1`, `Look 2` and so on, starting from the number of items plus one. */
export function freeName(word: string, items: readonly NamedItem[]): string {
  for (let number = items.length + 1; ; number++) {
    const name = `${word} ${number}`;
    if (!items.some((item) => item.name === name)) return name;
  }
}
