import { lightness } from '../../look/vectors.js';

/** The colours of a scene with their weights. Emptying it keeps its memory. */
export class WeightedColors {
  private readonly bins = new Map<number, Color>();
  /** A sum of all that was added, and that of before the last emptying. */
  private sum = Number.NaN;
  private sumBefore = Number.NaN;

  clear(): void {
    this.sumBefore = this.sum;
    this.sum = 0;
    for (const bin of this.bins.values()) Object.assign(bin, NO_COLOR);
  }

  /** Whether the colours are those of before the last emptying: under a light that moves, frame by frame. */
  get isUnchanged(): boolean {
    return this.sum === this.sumBefore;
  }

  /** Adds a colour in linear light. Weights that are not positive numbers are left out. */
  add(rgb: ArrayLike<number>, weight: number): void {
    if (!(weight > 0 && weight < Infinity)) return;
    const key = keyOf(rgb);
    if (!Number.isFinite(key)) return;
    let bin = this.bins.get(key);
    if (!bin) {
      bin = { ...NO_COLOR };
      this.bins.set(key, bin);
    }
    this.sum += weight * (1 + rgb[0] + 3 * rgb[1] + 9 * rgb[2]);
    bin.r += weight * clamp01(rgb[0]);
    bin.g += weight * clamp01(rgb[1]);
    bin.b += weight * clamp01(rgb[2]);
    bin.weight += weight;
  }

  /** Whether all are white, or there are none. */
  get isWhite(): boolean {
    for (const [key, { weight }] of this.bins) if (weight > 0 && key !== WHITE) return false;
    return true;
  }

  /** The mean colour of each bin, and its share of the weight. */
  get means(): Color[] {
    const bins = [...this.bins.values()].filter(({ weight }) => weight > 0);
    const all = bins.reduce((sum, { weight }) => sum + weight, 0);
    return bins.map(({ r, g, b, weight }) => ({
      r: r / weight,
      g: g / weight,
      b: b / weight,
      weight: weight / all,
    }));
  }
}

/** A colour in linear light, and its share of what is seen. */
export interface Color {
  r: number;
  g: number;
  b: number;
  weight: number;
}

const NO_COLOR: Readonly<Color> = { r: 0, g: 0, b: 0, weight: 0 };

/** The number of bins along red, green and blue. */
const BINS = 24;

const clamp01 = (value: number): number => Math.min(Math.max(value, 0), 1);
const binOf = (value: number): number => Math.round((BINS - 1) * lightness(clamp01(value)));
const keyOf = (rgb: ArrayLike<number>): number => (binOf(rgb[0]) * BINS + binOf(rgb[1])) * BINS + binOf(rgb[2]);
const WHITE = BINS ** 3 - 1;
