import type { Stroke } from './Stroke.js';

/** Half the length, in tiles, of the region around the end of a stroke that other ends should avoid. */
const REACH_FORWARD = 0.15;

/**
 * The density of the ends of strokes of one direction at each place of a level.
 *
 * Where many strokes end side by side, small holes appear. They hardly change the density along a stroke, but they repeat with
 * every tile and catch the eye. If the ends keep apart, there are no holes.
 */
export class StrokeEndField {
  private readonly columns: number;
  private readonly values: Float32Array;

  /** @param size texels per side of the level, a power of two */
  constructor(private readonly size: number) {
    this.columns = Math.min(size, 64);
    this.values = new Float32Array(size * this.columns);
  }

  /**
   * Adds both ends of a stroke.
   *
   * @param reach half the height of the region around each, in texels
   * @returns the number of cells visited
   */
  add(stroke: Stroke, reach: number): number {
    return this.addEnd(stroke, -0.5, reach) + this.addEnd(stroke, 0.5, reach);
  }

  /** The density at both ends of a stroke, summed; 1 is one other end at the same place. */
  atEnds(stroke: Stroke): number {
    return this.at(stroke, -0.5) + this.at(stroke, 0.5);
  }

  private addEnd(stroke: Stroke, end: number, reach: number): number {
    const { size, columns, values } = this;
    const forward = this.forward(stroke, end) * columns;
    const sideways = this.sideways(stroke, end) * size;
    const reachForward = REACH_FORWARD * columns;
    const lastColumn = Math.floor(forward + reachForward - 0.5);
    const firstRow = Math.ceil(sideways - reach - 0.5);
    const lastRow = Math.floor(sideways + reach - 0.5);
    let visited = 0;
    for (let column = Math.ceil(forward - reachForward - 0.5); column <= lastColumn; column++) {
      const x = (column + 0.5 - forward) / reachForward;
      const start = (column & (columns - 1)) * size;
      for (let row = firstRow; row <= lastRow; row++) {
        const y = (row + 0.5 - sideways) / reach;
        const inside = 1 - x * x - y * y;
        if (inside > 0) values[start + (row & (size - 1))] += inside * inside;
        visited++;
      }
    }
    return visited;
  }

  private at(stroke: Stroke, end: number): number {
    const { size, columns, values } = this;
    const column = Math.floor(this.forward(stroke, end) * columns) & (columns - 1);
    const row = Math.floor(this.sideways(stroke, end) * size) & (size - 1);
    return values[column * size + row];
  }

  private forward(stroke: Stroke, end: number): number {
    return (stroke.across ? stroke.v : stroke.u) + end * stroke.length;
  }

  private sideways(stroke: Stroke, end: number): number {
    return (stroke.across ? stroke.u : stroke.v) + end * stroke.length * stroke.slope;
  }
}
