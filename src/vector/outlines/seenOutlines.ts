import { liftOf } from '../../engraving/outlines.js';
import type { Bvh } from '../Bvh.js';
import type { Chain } from '../Chain.js';
import type { Projection } from '../Projection.js';
import type { ChainPlace, SeenTest } from '../visibleRuns.js';

/**
 * A test whether places of an outline are seen: lifted towards the eye by so much that their own surface does not hide them.
 *
 * @param leastHalf half the width, pixels, that it is lifted for at least
 */
export function outlineTest(chain: Chain, bvh: Bvh, projection: Projection, leastHalf = 0): SeenTest {
  const { pieces, radius } = chain.outline!;
  return ({ world, piece, share }: ChainPlace) => {
    const half = chain.halves[piece] + share * (chain.halves[piece + 1] - chain.halves[piece]);
    const units = Math.max(half, leastHalf) * projection.unitsPerPixel(projection.depthOf(...world));
    const lift = Math.max(liftOf(pieces[piece], units, radius), liftOf(pieces[piece + 1], units, radius));
    const { way, end } = projection.wayToEye(...world);
    return !bvh.isHidden(world, way, lift / Math.hypot(...way), end);
  };
}
