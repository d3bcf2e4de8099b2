import { profileAt, type Stroke, strokeOffset } from './Stroke.js';

/** Strokes closer than this many widths, centre line to centre line, begin to look merged. */
export const MERGING_WIDTHS = 2.5;

/** How a hand places strokes where it deviates from the even spacing of the styles. */
export interface PlacingHabit {
  /** Multiple of the usual distance beyond which strokes keep an even distance: 1 is even, larger values leave more to chance. */
  softness: number;
  /** Strength with which strokes avoid merging, 0 to 1. */
  apart: number;
  /** The share of its length over which a stroke keeps others away: smaller values let strokes of a row overlap, larger ones leave gaps. */
  share: number;
}

const EVENLY: PlacingHabit = { softness: 1, apart: 1, share: 1 };

/** The weight of distances ahead of a line's end, relative to those beside it: lines may follow each other closely. */
const AHEAD = 3;

/**
 * The density of the strokes of one direction at each place of a level. New strokes are placed where the density is low.
 *
 * A stroke of width w adds 1/(1 + (d/w)²)^¾ at distance d: a long tail, which evens out the image at all scales. At short
 * distances it also adds (1 − (d/2.5w)²)², which keeps strokes from merging.
 *
 * Praun et al. 2001 measure the gain of a candidate stroke in a pyramid of ink images instead. Strokes there have the same
 * width in texels on every pyramid level, so they meet at all distances, and the sum over the pyramid falls off like this
 * field. But that sum jumps at the borders of the pyramid's texels, which makes strokes line up with them. This field has no
 * such grid.
 *
 * Lines are long and nearly parallel to an axis, so a few columns are enough for them.
 */
export class StrokeDensityField {
  private readonly columns: number;
  private readonly values: Float32Array;
  /** Squared cosine of the strokes' mean angle: turns distances along the columns into distances across strokes. */
  private readonly cosine2: number;

  /**
   * @param size texels per side of the level, a power of two
   * @param short whether the strokes are dots or little longer, which need a column per texel
   * @param slope the mean angle of the strokes to their axis, as a tangent
   * @param habit how a hand places strokes; evenly by default
   */
  constructor(
    private readonly size: number,
    short: boolean,
    slope: number,
    private readonly habit: PlacingHabit = EVENLY,
  ) {
    this.columns = short ? size : Math.min(size, 64);
    this.cosine2 = 1 / (1 + slope * slope);
    this.values = new Float32Array(size * this.columns);
  }

  /**
   * Adds a stroke.
   *
   * @param reach where the tail ends, in texels
   * @returns the number of cells visited
   */
  add(stroke: Stroke, reach: number): number {
    const { size, columns, values, cosine2 } = this;
    const { softness, apart, share } = this.habit;
    const cell = size / columns;
    const centre = (stroke.across ? stroke.v : stroke.u) * size;
    const base = (stroke.across ? stroke.u : stroke.v) * size;
    const fullLength = 0.5 * stroke.length * size;
    const halfLength = share * fullLength;
    const ahead = halfLength > 0 ? AHEAD : 1;
    const ownWidth2 = 1 / (stroke.width * stroke.width);
    const inverseWidth2 = ownWidth2 / (softness * softness);
    const inverseMerging2 = ownWidth2 / (MERGING_WIDTHS * MERGING_WIDTHS);
    const inverseReach2 = 1 / (reach * reach);
    const first = Math.ceil((centre - halfLength - reach / ahead) / cell - 0.5);
    const last = Math.floor((centre + halfLength + reach / ahead) / cell - 0.5);
    let visited = 0;
    for (let column = first; column <= last; column++) {
      const forward = (column + 0.5) * cell - centre;
      const along = Math.min(halfLength, Math.max(-halfLength, forward));
      const beyond = (forward - along) * ahead;
      const x = halfLength > 0 ? along / fullLength : 0;
      const middle = base + size * strokeOffset(stroke, x);
      // Thin parts of a stroke of a hand leave room for others.
      const weight = stroke.profile ? profileAt(stroke.profile.width, x) : 1;
      const height = Math.sqrt(Math.max(0, reach * reach - beyond * beyond) / cosine2);
      const start = (column & (columns - 1)) * size;
      const lastRow = Math.floor(middle + height - 0.5);
      for (let row = Math.ceil(middle - height - 0.5); row <= lastRow; row++) {
        const sideways = row + 0.5 - middle;
        const distance2 = sideways * sideways * cosine2 + beyond * beyond;
        const fade = 1 - distance2 * inverseReach2;
        const widths = 1 + distance2 * inverseWidth2;
        const merging = Math.max(0, 1 - distance2 * inverseMerging2);
        const density = (fade * fade) / Math.sqrt(widths * Math.sqrt(widths)) + apart * merging * merging;
        values[start + (row & (size - 1))] += weight * density;
        visited++;
      }
    }
    return visited;
  }

  /** The mean density along a stroke's centre line. */
  meanAlong(stroke: Stroke): number {
    const { size, columns, values } = this;
    const mask = size - 1;
    const centre = (stroke.across ? stroke.v : stroke.u) * columns;
    const base = (stroke.across ? stroke.u : stroke.v) * size - 0.5;
    const fullLength = 0.5 * stroke.length * columns;
    const halfLength = this.habit.share * fullLength;
    let first = Math.ceil(centre - halfLength - 0.5);
    let last = Math.floor(centre + halfLength - 0.5);
    const { profile, bow, wave } = stroke;
    const tilt = 0.5 * stroke.length * stroke.slope;
    // Between the middles of two columns.
    if (last < first) first = last = Math.floor(centre);
    let sum = 0;
    for (let column = first; column <= last; column++) {
      const x = halfLength > 0 ? (column + 0.5 - centre) / fullLength : 0;
      // `strokeOffset`, inlined: this is the hottest loop.
      const offset = profile === undefined ? tilt * x + (1 - x * x) * (bow + wave * x) : strokeOffset(stroke, x);
      const place = base + size * offset;
      const row = Math.floor(place);
      const part = place - row;
      const start = (column & (columns - 1)) * size;
      const low = values[start + (row & mask)];
      sum += low + part * (values[start + ((row + 1) & mask)] - low);
    }
    return sum / (last - first + 1);
  }
}
