import { ModelError } from './ModelError.js';

/**
 * At 252 bytes per triangle, the baked attributes of larger models come near the limit of what a browser can allocate.
 */
const MAX_TRIANGLES = 2_000_000;

/** @throws ModelError if there are no triangles to draw, or too many */
export function checkTriangleCount(triangles: number): void {
  if (!(triangles > 0)) {
    throw new ModelError('The file holds no triangles; only surfaces can be hatched, not points or lines.');
  }
  if (triangles > MAX_TRIANGLES) {
    throw new ModelError(
      `The model has more than ${MAX_TRIANGLES.toLocaleString('en')} triangles, which this page cannot draw.`,
    );
  }
}
