import { type Stroke, strokeOffset } from './Stroke.js';

/** Strokes repel less far ahead of their ends than beside them: distances along a stroke count this much less. */
const END_STRETCH = 3;

/**
 * How crowded each place of one level is, as felt by the next stroke of the same direction.
 *
 * Each stroke adds 1/(1 + (d/w)²)^¾ at distance d from its centre line, w being its width: a core as wide as the
 * ink and a long tail. It stands for the pyramid of ink images in which Praun et al. 2001 measure how much a candidate
 * stroke gains (strokes there have the same width in the texels of every pyramid level, so they meet at all
 * distances): the sum over that pyramid falls off in the same way, but it jumps at the borders of the pyramid's
 * texels, which lines the strokes up with them. This field has no such grid.
 *
 * Lines are nearly parallel to an axis and long, so for them a few columns are enough.
 */
export class RepulsionField {
  private readonly columns: number;
  private readonly values: Float32Array;

  /**
   * @param size texels per side of the level, a power of two
   * @param dots whether the strokes are dots, which need a column per texel
   */
  constructor(
    private readonly size: number,
    dots: boolean,
  ) {
    this.columns = dots ? size : Math.min(size, 32);
    this.values = new Float32Array(size * this.columns);
  }

  /**
   * Adds a stroke.
   *
   * @param reach where the tail ends, in texels
   * @returns the number of cells visited
   */
  add(stroke: Stroke, reach: number): number {
    const { size, columns, values } = this;
    const cell = size / columns;
    const centre = (stroke.across ? stroke.v : stroke.u) * size;
    const base = (stroke.across ? stroke.u : stroke.v) * size;
    const halfLength = 0.5 * stroke.length * size;
    const stretch = halfLength > 0 ? END_STRETCH : 1;
    const inverseWidth2 = 1 / (stroke.width * stroke.width);
    const inverseReach2 = 1 / (reach * reach);
    const first = Math.ceil((centre - halfLength - reach * stretch) / cell - 0.5);
    const last = Math.floor((centre + halfLength + reach * stretch) / cell - 0.5);
    let visited = 0;
    for (let column = first; column <= last; column++) {
      const forward = (column + 0.5) * cell - centre;
      const along = Math.min(halfLength, Math.max(-halfLength, forward));
      const beyond = (forward - along) / stretch;
      const middle = base + size * strokeOffset(stroke, halfLength > 0 ? along / halfLength : 0);
      const height = Math.sqrt(Math.max(0, reach * reach - beyond * beyond));
      const start = (column & (columns - 1)) * size;
      const lastRow = Math.floor(middle + height - 0.5);
      for (let row = Math.ceil(middle - height - 0.5); row <= lastRow; row++) {
        const sideways = row + 0.5 - middle;
        const distance2 = sideways * sideways + beyond * beyond;
        const fade = 1 - distance2 * inverseReach2;
        const core = 1 + distance2 * inverseWidth2;
        values[start + (row & (size - 1))] += (fade * fade) / Math.sqrt(core * Math.sqrt(core));
        visited++;
      }
    }
    return visited;
  }

  /** The mean of the field along a stroke's centre line. */
  along(stroke: Stroke): number {
    const { size, columns, values } = this;
    const mask = size - 1;
    const centre = (stroke.across ? stroke.v : stroke.u) * columns;
    const base = (stroke.across ? stroke.u : stroke.v) * size - 0.5;
    const halfLength = 0.5 * stroke.length * columns;
    const first = halfLength > 0 ? Math.ceil(centre - halfLength - 0.5) : Math.floor(centre);
    const last = halfLength > 0 ? Math.floor(centre + halfLength - 0.5) : first;
    let sum = 0;
    for (let column = first; column <= last; column++) {
      const x = halfLength > 0 ? (column + 0.5 - centre) / halfLength : 0;
      const place = base + size * strokeOffset(stroke, x);
      const row = Math.floor(place);
      const part = place - row;
      const start = (column & (columns - 1)) * size;
      const low = values[start + (row & mask)];
      sum += low + part * (values[start + ((row + 1) & mask)] - low);
    }
    return sum / (last - first + 1);
  }
}
