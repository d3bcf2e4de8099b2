/** Numbers that look like chance and are the same for the same seed. */
export class Chance {
  constructor(private state: number) {}

  /** In [0, 1). */
  share(): number {
    this.state = (this.state + 0x6d2b79f5) | 0;
    let t = Math.imul(this.state ^ (this.state >>> 15), 1 | this.state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  }

  /** A whole number from 0 to `count` − 1. */
  index(count: number): number {
    return Math.floor(this.share() * count);
  }

  oneOf<Item>(items: readonly Item[]): Item {
    return items[this.index(items.length)];
  }
}
