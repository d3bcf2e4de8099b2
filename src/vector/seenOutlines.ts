import { liftOf, paperness } from '../engraving/outlines.js';
import type { Bvh } from './Bvh.js';
import type { Chain } from './Chain.js';
import type { Projection } from './Projection.js';
import { type ChainPlace, placeOn, type SeenTest } from './visibleRuns.js';

/** From where on beyond its side an outline looks for what lies behind it, pixels. */
const BEYOND = 1.5;

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

/** Makes an outline as wide as it is before what lies behind it: the paper, or a surface. Changes the widths of the chain. */
export function weighByStanding(chain: Chain, bvh: Bvh, projection: Projection): void {
  const { innerHalves } = chain.outline!;
  const { screen, halves, count } = chain;
  for (let i = 0; i < count; i++) {
    const [outer, inner] = [halves[i], innerHalves[i]];
    if (outer === inner || chain.margins[i] <= 0) continue;
    const [before, after] = [Math.max(i - 1, 0), Math.min(i + 1, count - 1)];
    const dx = screen[2 * after] - screen[2 * before];
    const dy = screen[2 * after + 1] - screen[2 * before + 1];
    const length = Math.hypot(dx, dy) || 1;
    const { world, x, y } = placeOn(chain, Math.min(i, count - 2), i < count - 1 ? 0 : 1, projection);
    const depth = projection.depthOf(...world);
    const reach = (Math.max(outer, inner) + BEYOND) / length;
    const gapAt = (sign: number): number => {
      const { origin, direction } = projection.rayThrough(x - sign * reach * dy, y + sign * reach * dx);
      return bvh.firstMet(origin, direction, projection.camera.near) - depth;
    };
    const height = projection.unitsPerPixel(depth) * projection.height;
    const paper = paperness(Math.max(gapAt(1), gapAt(-1)) / height);
    halves[i] = inner + paper * (outer - inner);
  }
}
