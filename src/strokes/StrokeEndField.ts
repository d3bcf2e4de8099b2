import type { Stroke } from './Stroke.js';

/** Half the length, in tiles, of the region around an end in which another end is unwelcome. */
const REACH_FORWARD = 0.15;

/**
 * How close each place of one level is to where other strokes of the same direction end.
 *
 * Crowding along a stroke hardly feels small holes, and holes appear where many strokes end side by side. They also
 * recur with every tile, and the eye finds them at once. Ends that keep apart leave no holes.
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

  /** How close the ends of a stroke would be to others; 1 is one other end at the same place. */
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
