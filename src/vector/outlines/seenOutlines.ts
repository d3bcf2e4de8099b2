import { OUTLINE_CONSTANTS } from '../../look/constants/outlineConstants.js';
import { combined, type Vec3 } from '../../look/vectors.js';
import type { Bvh } from '../Bvh.js';
import type { Chain } from '../Chain.js';
import type { Projection } from '../Projection.js';
import { liftOf, toleranceOf } from '../shading/outlines.js';
import type { ChainPlace, SeenTest } from '../visibleRuns.js';

const { BESIDE, CUT_SLOPE } = OUTLINE_CONSTANTS;

/**
 * A visibility test for an outline: it is lifted towards the eye so that its own surface does not hide it, and nothing may lie before it on
 * at least one side.
 *
 * @param leastHalf least half width, pixels, that the lift is computed for
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
    // A point that two pieces share belongs to both.
    return beside.isOpen(place, toleranceOf(pieces[piece + 1], pixel, radius));
  };
}

/** A test for whether the surface of an outline is cut out; null if no part of it may be. */
export function cutTest(chain: Chain, bvh: Bvh, projection: Projection): SeenTest | null {
  const { pieces, radius, isCutOut } = chain.outline!;
  if (!isCutOut) return null;
  const beside = new BesideOutline(chain, bvh, projection);
  return (place: ChainPlace) => {
    const pixel = projection.unitsPerPixel(projection.depthOf(...place.world));
    return beside.isEmpty(place, toleranceOf(pieces[place.piece + 1], pixel, radius) + CUT_SLOPE * pixel);
  };
}

/** Tests what lies before an outline on its two sides, where its own surface is less in the way. */
class BesideOutline {
  constructor(
    private readonly chain: Chain,
    private readonly bvh: Bvh,
    private readonly projection: Projection,
  ) {}

  /**
   * Whether nothing lies before a place by more than the tolerance, world units, on at least one side; beyond the picture nothing is known.
   */
  isOpen(place: ChainPlace, tolerance: number): boolean {
    const { projection, bvh } = this;
    const depth = projection.depthOf(...place.world);
    if (depth <= projection.camera.near) return true;
    const sides = this.sidesOf(place);
    if (!sides.every((side) => projection.contains(...side))) return true;
    return sides.some((side) => {
      const { point, way, end } = this.rayFrom(side, depth);
      return !bvh.isHidden(point, way, tolerance / depth, end);
    });
  }

  /** Whether nothing lies before what is behind a place, by more than the tolerance, world units, on both sides. */
  isEmpty(place: ChainPlace, tolerance: number): boolean {
    const { projection, bvh } = this;
    const depth = projection.depthOf(...place.world) + tolerance;
    if (depth <= projection.camera.near) return false;
    return this.sidesOf(place).every((side) => {
      const { point, way, end } = this.rayFrom(side, depth);
      return !bvh.isHidden(point, way, 0, end);
    });
  }

  private sidesOf({ world, piece }: ChainPlace): readonly (readonly [number, number])[] {
    const { projection } = this;
    const [x, y] = projection.project(...projection.toView(world as Vec3));
    const [dx, dy] = this.sideways(piece);
    return [1, -1].map((sign) => [x + sign * dx, y + sign * dy] as const);
  }

  /** The ray to the eye from what a pixel shows at a depth. */
  private rayFrom(pixel: readonly [number, number], depth: number) {
    const { projection } = this;
    const { origin, direction } = projection.rayThrough(...pixel);
    const point = combined(1, origin, depth, direction);
    return { point, ...projection.wayToEye(...point) };
  }

  /** The unit vector perpendicular to a piece on the picture, in which the wobble of the hand is removed. */
  private sideways(piece: number): readonly [number, number] {
    const { screen } = this.chain;
    const dx = screen[2 * piece + 2] - screen[2 * piece];
    const dy = screen[2 * piece + 3] - screen[2 * piece + 1];
    const length = Math.hypot(dx, dy);
    return length > 0 ? [(-BESIDE * dy) / length, (BESIDE * dx) / length] : [0, BESIDE];
  }
}
