import { OUTLINE_CONSTANTS } from '../../look/constants/outlineConstants.js';
import { combined, type Vec3 } from '../../look/vectors.js';
import type { Bvh } from '../Bvh.js';
import type { Chain } from '../Chain.js';
import type { Projection } from '../Projection.js';
import { liftOf, lineWeightAt, strideOf, toleranceOf } from '../shading/outlines.js';
import { type ChainPlace, placeOn, type SeenTest } from '../visibleRuns.js';

const { BESIDE, CUT_SLOPE } = OUTLINE_CONSTANTS;

/**
 * A visibility test for an outline: it is lifted towards the eye so that its own surface does not hide it, and nothing may lie before it on
 * at least one side.
 *
 * @param leastHalf least half width, pixels, that the lift is computed for
 */
export function outlineTest(chain: Chain, bvh: Bvh, projection: Projection, leastHalf = 0): SeenTest {
  const { points, radius } = chain.outline!;
  const beside = new BesideOutline(chain, bvh, projection);
  return (place: ChainPlace) => {
    const { world, piece, share } = place;
    const half = chain.halves[piece] + share * (chain.halves[piece + 1] - chain.halves[piece]);
    const pixel = projection.unitsPerPixel(projection.depthOf(...world));
    const units = Math.max(half, leastHalf) * pixel;
    const lift = Math.max(liftOf(points[piece], units, radius), liftOf(points[piece + 1], units, radius));
    const { way, end } = projection.wayToEye(...world);
    if (bvh.isHidden(world, way, lift / Math.hypot(...way), end)) return false;
    // A point that two pieces share belongs to both.
    return beside.isOpen(place, toleranceOf(points[piece + 1], pixel, radius));
  };
}

/** A test for whether the surface of an outline is cut out; null if no part of it may be. */
export function cutTest(chain: Chain, bvh: Bvh, projection: Projection): SeenTest | null {
  const { points, radius, isCutOut } = chain.outline!;
  if (!isCutOut) return null;
  const beside = new BesideOutline(chain, bvh, projection);
  return (place: ChainPlace) => {
    const pixel = projection.unitsPerPixel(projection.depthOf(...place.world));
    return beside.isEmpty(place, toleranceOf(points[place.piece + 1], pixel, radius) + CUT_SLOPE * pixel);
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

/**
 * Sets the width of an outline by what lies behind it, paper or a surface, and widens it where another one ends behind it. Changes the
 * widths of the chain. Yields its progress.
 */
export function* weighByHierarchy(chain: Chain, bvh: Bvh, projection: Projection): Generator<number, void, void> {
  const { points, width } = chain.outline!;
  const { screen, halves, count, margins } = chain;
  const placeAt = (i: number): ChainPlace => placeOn(chain, Math.min(i, count - 2), i < count - 1 ? 0 : 1, projection);
  const depthAt = (i: number): number => projection.depthOf(...placeAt(i).world);
  for (let i = 0; i < count; i++) {
    if (i % 32 === 31) yield i / count;
    const point = points[i];
    const [outer, inner] = [halves[i], point.innerHalf];
    if ((outer === inner && point.accent === 0 && point.contour === 0) || margins[i] <= 0) continue;
    const [before, after] = [Math.max(i - 1, 0), Math.min(i + 1, count - 1)];
    const dx = screen[2 * after] - screen[2 * before];
    const dy = screen[2 * after + 1] - screen[2 * before + 1];
    const length = Math.hypot(dx, dy) || 1;
    // A straight edge may run away from the eye. Contours are taken to keep their depth.
    const slope = point.isSmooth ? 0 : (depthAt(after) - depthAt(before)) / length;
    const gaps = new GapReader({ ...placeAt(i), along: [dx / length, dy / length], slope }, bvh, projection);
    const { paper, accent } = gaps.lineWeight(Math.max(outer, inner) + OUTLINE_CONSTANTS.BEYOND, strideOf(width));
    const whole = inner + paper * (outer - inner);
    const lost = paper * outer * (1 - point.left);
    halves[i] = (whole - lost) * (1 + point.accent * accent);
    point.contour *= paper;
    point.left = whole > 0 ? 1 - lost / whole : 1;
  }
}

/** A place on an outline. */
interface OutlinePlace {
  world: readonly [number, number, number];
  x: number;
  y: number;
  /** Unit direction of the outline on the picture. */
  along: readonly [number, number];
  /** Change of its depth per pixel. */
  slope: number;
}

/** Measures what lies behind a place on an outline. */
class GapReader {
  private readonly depth: number;
  private readonly height: number;

  constructor(
    private readonly place: OutlinePlace,
    private readonly bvh: Bvh,
    private readonly projection: Projection,
  ) {
    this.depth = projection.depthOf(...place.world);
    this.height = projection.unitsPerPixel(this.depth) * projection.height;
  }

  /** @param stride distance between steps along the outline, pixels */
  lineWeight(reach: number, stride: number): { paper: number; accent: number } {
    const [left, right] = [this.gapAt(reach, 0), this.gapAt(-reach, 0)];
    const outside = left > right ? reach : -reach;
    return lineWeightAt(Math.max(left, right), (step) => {
      const away = stride * step;
      return this.isInView(outside, away) ? this.gapAt(outside, away) : undefined;
    });
  }

  private pixelAt(beside: number, along: number): readonly [number, number] {
    const { x, y, along: way } = this.place;
    return [x + along * way[0] - beside * way[1], y + along * way[1] + beside * way[0]];
  }

  private isInView(beside: number, along: number): boolean {
    return this.projection.contains(...this.pixelAt(beside, along));
  }

  /**
   * The distance from the outline back to what is visible so many pixels beside the place and along the outline: in heights of the view, up
   * to 1.
   */
  private gapAt(beside: number, along: number): number {
    const { origin, direction } = this.projection.rayThrough(...this.pixelAt(beside, along));
    const met = this.bvh.firstMet(origin, direction, this.projection.camera.near);
    return Math.min((met - this.depth - along * this.place.slope) / this.height, 1);
  }
}
