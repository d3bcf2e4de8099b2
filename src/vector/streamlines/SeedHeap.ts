/** A place where a line may begin. */
export interface Seed {
  x: number;
  y: number;
  /** The length that its line may have, millimetres. */
  length: number;
  /** The chance of its line, from 0 to 1. */
  lot: number;
}

/** Seeds, the longest first. */
export class SeedHeap {
  private readonly seeds: Seed[] = [];

  /** The length that the first may have; 0 without any. */
  get longest(): number {
    return this.seeds.length > 0 ? this.seeds[0].length : 0;
  }

  push(seed: Seed): void {
    const { seeds } = this;
    let i = seeds.length;
    seeds.push(seed);
    while (i > 0) {
      const above = (i - 1) >> 1;
      if (seeds[above].length >= seed.length) break;
      seeds[i] = seeds[above];
      i = above;
    }
    seeds[i] = seed;
  }

  pop(): Seed | undefined {
    const { seeds } = this;
    const first = seeds[0];
    const last = seeds.pop();
    if (!last || seeds.length === 0) return last;
    let i = 0;
    for (;;) {
      let below = 2 * i + 1;
      if (below >= seeds.length) break;
      if (below + 1 < seeds.length && seeds[below + 1].length > seeds[below].length) below++;
      if (seeds[below].length <= last.length) break;
      seeds[i] = seeds[below];
      i = below;
    }
    seeds[i] = last;
    return first;
  }
}
