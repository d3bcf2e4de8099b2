/** Something of the user's own with a name. */
export interface NamedItem {
  name: string;
  /** The address of a small image. */
  picture?: string | undefined;
  /** The key that chooses it. */
  key?: string;
}

/** A list of them. What changes it returns a sentence for the user where there is something to say. */
export interface NamedList {
  readonly items: readonly NamedItem[];
  readonly isFull: boolean;
  /** A name that none of them has. */
  readonly freeName: string;
  /** Keeps what is shown. */
  add(name: string): string | undefined;
  choose(index: number): void;
  rename(index: number, name: string): string | undefined;
  remove(index: number): string | undefined;
  /** Whether it is what is shown. */
  isShown(index: number): boolean;
}

/** The first of `Look 1`, `Look 2` and so on that is free, from the number that comes next. */
export function freeName(word: string, items: readonly NamedItem[]): string {
  for (let number = items.length + 1; ; number++) {
    const name = `${word} ${number}`;
    if (!items.some((item) => item.name === name)) return name;
  }
}
