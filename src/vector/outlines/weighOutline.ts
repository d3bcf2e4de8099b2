import { OUTLINE_CONSTANTS } from '../../look/constants/outlineConstants.js';
import type { Bvh } from '../Bvh.js';
import type { Chain } from '../Chain.js';
import type { Projection } from '../Projection.js';
import { lineWeightAt, strideOf } from '../shading/lineWeight.js';
import { type ChainPlace, placeOn } from '../visibleRuns.js';

/**
 * Sets the width of an outline by what lies behind it, paper or a surface, and widens it where another one ends behind it. Changes the
 * widths of the chain. Yields its progress.
 */
export function* weighOutline(chain: Chain, bvh: Bvh, projection: Projection): Generator<number, void, void> {
  const { innerHalves, accents, contours, lefts, width, pieces } = chain.outline!;
  const { screen, halves, count, margins } = chain;
  const placeAt = (i: number): ChainPlace => placeOn(chain, Math.min(i, count - 2), i < count - 1 ? 0 : 1, projection);
  const depthAt = (i: number): number => projection.depthOf(...placeAt(i).world);
  for (let i = 0; i < count; i++) {
    if (i % 32 === 31) yield i / count;
    const [outer, inner] = [halves[i], innerHalves[i]];
    if ((outer === inner && accents[i] === 0 && contours[i] === 0) || margins[i] <= 0) continue;
    const [before, after] = [Math.max(i - 1, 0), Math.min(i + 1, count - 1)];
    const dx = screen[2 * after] - screen[2 * before];
    const dy = screen[2 * after + 1] - screen[2 * before + 1];
    const length = Math.hypot(dx, dy) || 1;
    // A straight edge may run away from the eye. Contours are taken to keep their depth.
    const slope = pieces[i].isSmooth ? 0 : (depthAt(after) - depthAt(before)) / length;
    const gaps = new GapReader({ ...placeAt(i), along: [dx / length, dy / length], slope }, bvh, projection);
    const { paper, accent } = gaps.lineWeight(Math.max(outer, inner) + OUTLINE_CONSTANTS.BEYOND, strideOf(width));
    const whole = inner + paper * (outer - inner);
    const lost = paper * outer * (1 - lefts[i]);
    halves[i] = (whole - lost) * (1 + accents[i] * accent);
    contours[i] *= paper;
    lefts[i] = whole > 0 ? 1 - lost / whole : 1;
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
