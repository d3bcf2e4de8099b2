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

/** How far lines of one set lie apart, and where they end. Lengths in millimetres. */
export class LineLaws {
  constructor(
    readonly fields: LineFields,
    readonly set: number,
    /** The width of the pen. */
    readonly pen: number,
    private readonly gains: ToneGains,
  ) {}

  /** The tone at which a line ends. lot: of the line, from 0 to 1. */
  lightest(lot: number): number {
    return this.set === 0 ? LIGHTEST + SPREAD * lot : LIGHTEST_ABOVE + SPREAD_ABOVE * lot;
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
