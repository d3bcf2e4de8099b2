/** A surface of a scene: all that has one material. */
export interface SeenSurface {
  readonly key: string;
  /** Whether it is of nothing but small parts. */
  isSmall: boolean;
  /** The sums of red, green and blue in linear light by weight, and the weight. */
  r: number;
  g: number;
  b: number;
  weight: number;
  /** The number of its samples. */
  count: number;
}

interface Point {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** The share of a surface's samples that lie beside another one where the two are neighbours. */
const LEAST_CONTACT = 0.05;

/** The surfaces of a scene, and samples of where they lie. */
export class SeenSurfaces {
  readonly all: SeenSurface[] = [];
  private readonly indices = new Map<string, number>();
  private readonly samples: (Point & { readonly surface: number })[] = [];

  clear(): void {
    this.all.length = this.samples.length = 0;
    this.indices.clear();
  }

  /** The index of a surface by its key. @param isSmall whether it is of small parts here */
  indexOf(key: string, isSmall = false): number {
    let index = this.indices.get(key);
    if (index === undefined) {
      index = this.all.push({ key, isSmall, r: 0, g: 0, b: 0, weight: 0, count: 0 }) - 1;
      this.indices.set(key, index);
    }
    this.all[index].isSmall &&= isSmall;
    return index;
  }

  /** Adds a place of a surface with its colour in linear light. Places that are no numbers, and weights that are not positive, are left out. */
  add(index: number, { x, y, z }: Point, color: ArrayLike<number>, weight: number): void {
    const [r, g, b] = [color[0], color[1], color[2]];
    if (!(weight > 0 && weight < Infinity && Number.isFinite(x + y + z + r + g + b))) return;
    this.samples.push({ x, y, z, surface: index });
    const surface = this.all[index];
    surface.r += weight * r;
    surface.g += weight * g;
    surface.b += weight * b;
    surface.weight += weight;
    surface.count++;
  }

  /**
   * For each surface the indices of those that lie beside it: a twentieth of the samples of either is within a distance of the other.
   *
   * @param reach the distance in the world
   */
  neighbours(reach: number): ReadonlySet<number>[] {
    const found = this.all.map(() => new Set<number>());
    const met = this.all.map(() => new Map<number, number>());
    if (reach > 0)
      for (const [surface, others] of this.encounters(reach))
        for (const other of others) met[surface].set(other, (met[surface].get(other) ?? 0) + 1);
    for (const [i, counts] of met.entries())
      for (const [j, count] of counts) {
        if (count < LEAST_CONTACT * this.all[i].count) continue;
        found[i].add(j);
        found[j].add(i);
      }
    return found;
  }

  /** For each sample its surface, and the other surfaces within a distance of it. */
  private *encounters(reach: number): Generator<[surface: number, others: ReadonlySet<number>]> {
    const cells = new Map<number, SeenSurfaces['samples']>();
    for (const sample of this.samples) {
      const key = cellKey(cellOf(sample.x, reach), cellOf(sample.y, reach), cellOf(sample.z, reach));
      const cell = cells.get(key);
      if (cell) cell.push(sample);
      else cells.set(key, [sample]);
    }
    for (const { x, y, z, surface } of this.samples) {
      const others = new Set<number>();
      const [a, b, c] = [cellOf(x, reach), cellOf(y, reach), cellOf(z, reach)];
      for (let i = 0; i < 27; i++) {
        const cell = cells.get(cellKey(a + (i % 3) - 1, b + (Math.floor(i / 3) % 3) - 1, c + Math.floor(i / 9) - 1));
        for (const other of cell ?? []) {
          if (other.surface === surface || others.has(other.surface)) continue;
          if ((other.x - x) ** 2 + (other.y - y) ** 2 + (other.z - z) ** 2 <= reach ** 2) others.add(other.surface);
        }
      }
      yield [surface, others];
    }
  }
}

/** The number of cells along an axis, about the origin, up to which no two have the same key; others share one. */
const CELLS = 2 ** 17;

const cellOf = (value: number, reach: number): number => Math.floor(value / reach);
const cellKey = (x: number, y: number, z: number): number => (x * CELLS + y) * CELLS + z;
