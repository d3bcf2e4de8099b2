import type { Bvh } from '../Bvh.js';
import type { Projection } from '../Projection.js';
import type { Sheet } from './Sheet.js';

/** Halvings of a step at the end of a line. */
const HALVINGS = 7;
/** A surface goes on where its depth is as expected, within so many times what it changes by, and as many samples. */
const LEEWAY = 2.5;

/** Finds where lines end at outlines, by rays. Lengths in millimetres on the sheet. */
export class LineEnds {
  constructor(
    private readonly sheet: Sheet,
    private readonly bvh: Bvh,
    private readonly projection: Projection,
  ) {}

  /**
   * How far from its last point a line ends, where its surface ends there: below 0 before it; 0 if the surface goes on for a step.
   *
   * @param ux and `uy`, the unit direction in which it ends
   */
  beyond(x: number, y: number, ux: number, uy: number, step: number): number {
    const { sheet, projection } = this;
    // A point counts by its nearest sample, and may lie just beside its surface; the one before it does not.
    const [fromX, fromY] = [x - step * ux, y - step * uy];
    if (!sheet.isParted(fromX, fromY, x + step * ux, y + step * uy)) return 0;
    const depth = this.depthAt(fromX, fromY);
    // A ground is met by no ray.
    if (!(depth < Infinity)) {
      const isFree = (way: number): boolean => !sheet.isParted(fromX, fromY, fromX + way * ux, fromY + way * uy);
      return this.within(2 * step, isFree) - step;
    }
    const slope = (2 * (depth - this.depthAt(fromX - 0.5 * step * ux, fromY - 0.5 * step * uy))) / step;
    const sample = (sheet.size / sheet.scale) * projection.unitsPerPixel(depth);
    const goesOn = (way: number): boolean =>
      Math.abs(this.depthAt(fromX + way * ux, fromY + way * uy) - depth - slope * way) <
      LEEWAY * (Math.abs(slope) * way + sample);
    return goesOn(2 * step) ? 0 : this.within(2 * step, goesOn) - step;
  }

  /** How far a surface goes on that ends within a step. */
  private within(step: number, goesOn: (way: number) => boolean): number {
    let [on, off] = [0, step];
    for (let k = 0; k < HALVINGS; k++) {
      const middle = 0.5 * (on + off);
      if (goesOn(middle)) on = middle;
      else off = middle;
    }
    return on;
  }

  /** The distance of what is seen at a place along the camera's axis; Infinity for nothing. */
  private depthAt(x: number, y: number): number {
    const { origin, direction } = this.projection.rayThrough(x / this.sheet.scale, y / this.sheet.scale);
    return this.bvh.firstMet(origin, direction, this.projection.camera.near);
  }
}
