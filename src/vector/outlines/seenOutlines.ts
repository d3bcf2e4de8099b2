import { OUTLINE_CONSTANTS } from '../../engraving/constants/outlineConstants.js';
import { liftOf, toleranceOf } from '../../engraving/outlines.js';
import { combined, type Vec3 } from '../../engraving/vectors.js';
import type { Bvh } from '../Bvh.js';
import type { Chain } from '../Chain.js';
import type { Projection } from '../Projection.js';
import type { ChainPlace, SeenTest } from '../visibleRuns.js';

/**
 * A test whether places of an outline are seen: lifted towards the eye by so much that their own surface does not hide them, and with
 * nothing before them on one side at least.
 *
 * @param leastHalf half the width, pixels, that it is lifted for at least
 */
export function outlineTest(chain: Chain, bvh: Bvh, projection: Projection, leastHalf = 0): SeenTest {
  const { pieces, radius } = chain.outline!;
  const beside = new BesideOutline(chain, bvh, projection);
  return (place: ChainPlace) => {
    const { world, piece, share } = place;
    const half = chain.halves[piece] + share * (chain.halves[piece + 1] - chain.halves[piece]);
    const pixel = projection.unitsPerPixel(projection.depthOf(...world));
    const units = Math.max(half, leastHalf) * pixel;
    const lift = Math.max(liftOf(pieces[piece], units, radius), liftOf(pieces[piece + 1], units, radius));
    const { way, end } = projection.wayToEye(...world);
    if (bvh.isHidden(world, way, lift / Math.hypot(...way), end)) return false;
    // What two pieces share at a point is of both of them.
    return beside.isOpen(place, toleranceOf(pieces[piece + 1], pixel, radius));
  };
}

/** Looks what lies before an outline beside it, where less of its own surface does. */
class BesideOutline {
  constructor(
    private readonly chain: Chain,
    private readonly bvh: Bvh,
    private readonly projection: Projection,
  ) {}

  /** Whether on one side nothing lies before a place by more than the tolerance, world units; beyond the picture nothing is known. */
  isOpen({ world, piece }: ChainPlace, tolerance: number): boolean {
    const { projection, bvh } = this;
    const depth = projection.depthOf(...world);
    if (depth <= projection.camera.near) return true;
    const [x, y] = projection.project(...projection.toView(world as Vec3));
    const [dx, dy] = this.sideways(piece);
    const sides = [1, -1].map((sign) => [x + sign * dx, y + sign * dy] as const);
    if (!sides.every((side) => projection.contains(...side))) return true;
    return sides.some((side) => {
      const { origin, direction } = projection.rayThrough(...side);
      const place = combined(1, origin, depth, direction);
      const { way, end } = projection.wayToEye(...place);
      return !bvh.isHidden(place, way, tolerance / depth, end);
    });
  }

  /** Square to a piece on the picture. The hand shifts it there, and nothing else. */
  private sideways(piece: number): readonly [number, number] {
    const { screen } = this.chain;
    const dx = screen[2 * piece + 2] - screen[2 * piece];
    const dy = screen[2 * piece + 3] - screen[2 * piece + 1];
    const length = Math.hypot(dx, dy);
    const { BESIDE } = OUTLINE_CONSTANTS;
    return length > 0 ? [(-BESIDE * dy) / length, (BESIDE * dx) / length] : [0, BESIDE];
  }
}
