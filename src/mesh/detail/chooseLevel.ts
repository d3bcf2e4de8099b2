/** How far a level may lie from the whole mesh, in pixels: less than a pixel's samples are apart. */
export const MOST_PIXELS = 1 / 3;

/** A simpler level than the one that is drawn must be this much better than it needs to be, so that nothing flickers between the two. */
const CALM = 0.8;

/**
 * The simplest level that cannot be told from the whole mesh.
 *
 * @param levels from the whole mesh on, in order of their errors
 * @param pixelsPerUnit the size of an object unit in the picture, where the mesh is nearest
 * @param before the level that was drawn before
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
