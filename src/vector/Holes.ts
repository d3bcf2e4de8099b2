import { Painter } from './Painter.js';
import type { Cutout } from './PaintLook.js';
import type { SurfaceDetails } from './SurfaceDetails.js';

/** Knows where triangles of a scene have holes, because their alpha is too low. */
export class Holes {
  private readonly cutouts: { details: SurfaceDetails; painter: Painter; end: number }[];

  constructor(cutouts: readonly Cutout[]) {
    this.cutouts = cutouts.map(({ details, paint }) => ({
      details,
      painter: new Painter(paint, details),
      end: details.firstTriangle + details.corners.length / 3,
    }));
  }

  /** Whether there is a hole at a place of a triangle: u and v are the weights of its second and third corner. */
  isOpen(triangle: number, u: number, v: number): boolean {
    const cutout = this.cutoutOf(triangle);
    if (!cutout) return false;
    const { corners, firstTriangle, stride, numbers } = cutout.details;
    const c = 3 * (triangle - firstTriangle);
    const at = new Float64Array(stride);
    for (const [k, weight] of [1 - u - v, u, v].entries()) {
      const o = stride * corners[c + k];
      for (let i = 0; i < stride; i++) at[i] += weight * numbers[o + i];
    }
    return cutout.painter.standingAt(at) < 0;
  }

  /** By halving: they stand in the order of their triangles. */
  private cutoutOf(triangle: number): (typeof this.cutouts)[number] | undefined {
    let [low, high] = [0, this.cutouts.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (triangle < this.cutouts[middle].end) high = middle;
      else low = middle + 1;
    }
    const found = this.cutouts[low];
    return found && triangle >= found.details.firstTriangle ? found : undefined;
  }
}
