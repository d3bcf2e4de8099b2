import { combined, cross, dot, type Vec3, vectorAt } from '../../look/vectors.js';
import type { Bvh } from '../Bvh.js';
import { type LineSurface, placeFrom, readTriangle, STRIDE, WORLD } from '../LineSurface.js';
import type { Projection } from '../Projection.js';
import type { ToneReader } from '../ToneReader.js';
import { interpolated, PlaceInTriangle } from './DetailReader.js';

/** A range of triangles of the scene that belong to a see-through surface. */
export interface TranslucentRange {
  /** The first of them, and the end of the range. */
  first: number;
  end: number;
  /** The share of what lies behind one of them that stays visible. */
  left: number;
}

/** Two hits on a ray no further apart than this share of it are one, since edges belong to two triangles. */
const SAME = 1e-9;
/** Shares are rounded to one part in so many. */
const STEPS = 1000;
/** Smaller shares count as nothing. */
const LEAST = 0.02;

/** A hit of a see-through surface. */
interface MetSurface {
  range: TranslucentRange;
  triangle: number;
  place: number;
}

/** Computes the visibility of what lies behind see-through surfaces. */
export class Translucency {
  /**
   * @param above height above surfaces at which rays start, world units
   * @param tones tones of see-through surfaces that are hatched themselves
   */
  constructor(
    private readonly bvh: Bvh,
    private readonly projection: Projection,
    private readonly translucent: readonly TranslucentRange[],
    private readonly above: number,
    private readonly tones: readonly TranslucentTone[],
  ) {}

  /** Whether there is any such surface. */
  get isThere(): boolean {
    return this.translucent.length > 0;
  }

  /** The visible share of a place, from 0 to 1. triangle: that of the place; −1 for none. */
  transmittance(world: Vec3, triangle: number): number {
    if (!this.isThere) return 1;
    const left = this.meet(world, triangle).reduce((share, { range }) => share * range.left, 1);
    return left < LEAST ? 0 : Math.round(STEPS * left) / STEPS;
  }

  /**
   * A factor on the width of lines behind see-through surfaces: the strokes of those cover some of them, where the canvas adds the inks.
   * Under a share `t` of strokes the visible ink is drawn over 1 − t times.
   */
  deepening(world: Vec3, triangle: number): number {
    if (this.tones.length === 0) return 1;
    const { way } = this.projection.wayToEye(...world);
    let factor = 1;
    for (const { range, triangle: other, place } of this.meet(world, triangle)) {
      const printed =
        this.tones.find(({ first }) => first === range.first)?.at(other, combined(1, world, place, way)) ?? 0;
      factor /= Math.max(1 - printed, range.left);
    }
    return factor;
  }

  private meet(world: Vec3, triangle: number): MetSurface[] {
    const { way, end } = this.projection.wayToEye(...world);
    const met: MetSurface[] = [];
    this.bvh.eachFading(world, way, this.above / Math.hypot(...way), end, triangle, (other, place) => {
      const range = this.translucent.find(({ first, end: last }) => other >= first && other < last);
      if (range && !met.some((one) => one.range === range && Math.abs(one.place - place) < SAME))
        met.push({ range, triangle: other, place });
    });
    return met;
  }
}

/** Computes the tone of a see-through surface, by the triangles that it had before subdivision. */
export class TranslucentTone {
  /** The first of its triangles. */
  readonly first: number;
  private readonly surface: LineSurface;

  /** @param surface before it is subdivided, which changes it */
  constructor(
    surface: LineSurface,
    private readonly toneReader: ToneReader,
    private readonly projection: Projection,
  ) {
    this.surface = { ...surface };
    this.first = surface.parents[0];
  }

  /** The printed tone at a place of a triangle of the scene. */
  at(triangle: number, world: Vec3): number {
    const { surface, toneReader, projection } = this;
    const { vertices, triangles } = surface;
    const t = triangle - this.first;
    const corners = vectorAt(triangles, 3 * t);
    const [a, b, c] = corners.map((vertex) => vectorAt(vertices, STRIDE * vertex + WORLD));
    const numbers = interpolated(vertices, STRIDE, corners, new PlaceInTriangle(a, b, c).weightsAt(world));
    const { way } = projection.wayToEye(...world);
    const isFront = dot(cross(combined(1, b, -1, a), combined(1, c, -1, a)), way) >= 0;
    return toneReader.read(placeFrom(numbers, readTriangle(surface, t), isFront ? 1 : -1), 'none').tone;
  }
}
