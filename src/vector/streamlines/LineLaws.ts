import type { LineFields } from './LineFields.js';
import type { ToneGains } from './ToneGains.js';

/** The farthest that lines lie apart, in widths of the pen. */
const FARTHEST = 12;
/** Tones below this one ask for no finer distance. */
const LEAST_TONE = 0.02;
/** Lines end below a tone that differs from line to line: that of the first set, and of those that lie over it. */
const LIGHTEST = 0.055;
const LIGHTEST_ABOVE = 0.06;
const SPREAD = 0.05;
const SPREAD_ABOVE = 0.14;

/**
 * No line is placed nearer to others than this, in widths of the pen, and moved lines are cut where they came nearer than that; in the black of a woodcut lines
 * may overlap more, so that none of it stays white where they run together.
 */
const NEAREST = { line: 1.02, block: 0.65 };
const CROWDED = { line: 0.97, block: 0.6 };

/** How far lines of one set lie apart, and where they end. Lengths in millimetres. */
export class LineLaws {
  /** No line is placed nearer to others; and moved lines are cut where they came nearer. */
  readonly nearest: number;
  readonly crowded: number;

  /** @param isBlock whether lines fill the block of a woodcut */
  constructor(
    readonly fields: LineFields,
    readonly set: number,
    /** The width of the pen. */
    readonly pen: number,
    readonly gains: ToneGains,
    isBlock = false,
  ) {
    this.nearest = pen * NEAREST[isBlock ? 'block' : 'line'];
    this.crowded = pen * CROWDED[isBlock ? 'block' : 'line'];
  }

  /** The tone at which a line may begin. lot: of the line, from 0 to 1. */
  lightest(lot: number): number {
    return this.set === 0 ? LIGHTEST + SPREAD * lot : LIGHTEST_ABOVE + SPREAD_ABOVE * lot;
  }

  /** The tone at which a line that has begun ends, by a chance that differs from the one by which it began. */
  endsAt(lot: number): number {
    return this.lightest((lot * 7.31) % 1);
  }

  /** The distance asked for where the fields look. */
  apartAt(x: number, y: number): number {
    const { fields, pen, gains } = this;
    return Math.min(pen / (Math.max(fields.density, LEAST_TONE) * gains.at(x, y)), FARTHEST * pen);
  }

  /** Looks at a place, and returns the distance asked for. */
  look(x: number, y: number): number {
    this.fields.look(this.set, x, y);
    return this.apartAt(x, y);
  }
}
