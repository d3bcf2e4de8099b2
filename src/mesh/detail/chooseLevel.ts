/** Largest distance of a level from the whole mesh, in pixels: less than the distance of the samples in a pixel. */
export const MOST_PIXELS = 1 / 3;

/** Hysteresis: a simpler level than the current one must be this much better than needed, so that levels do not flicker. */
const CALM = 0.8;

/**
 * The simplest level that looks like the whole mesh.
 *
 * @param levels the levels by growing error, the whole mesh first
 * @param pixelsPerUnit pixels per object unit where the mesh is nearest
 * @param before the current level
 */
export function chooseLevel(
  levels: readonly { readonly error: number }[],
  pixelsPerUnit: number,
  before: number,
): number {
  let chosen = 0;
  for (let i = 1; i < levels.length; i++) {
    const most = i > before ? CALM * MOST_PIXELS : MOST_PIXELS;
    if (levels[i].error * pixelsPerUnit <= most) chosen = i;
  }
  return chosen;
}
