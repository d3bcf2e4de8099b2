import type { LiftedPiece } from './shading/outlines.js';

/** A line on a surface, point by point. A closed one ends with its first point. */
export interface Chain {
  count: number;
  /** Pixels of the picture: two numbers per point. */
  screen: Float64Array;
  /** World space: three numbers per point. */
  world: Float64Array;
  /** Half the width at each point, pixels. */
  halves: Float64Array;
  /** Above 0 where there is a line at all, linear between points. */
  margins: Float64Array;
  /** The triangle of the scene that the piece after each point lies on; −1 for edges. */
  triangles: Int32Array;
  /** How far the middle of the line lies beside each point, pixels of the picture: two numbers per point; null where it lies there. */
  shifts: Float64Array | null;
  isClosed: boolean;
  /** Field space: three numbers per point of a line on a surface; null for others. */
  field: Float64Array | null;
  /** A number in [0, 1) that belongs to the line. */
  hash: number;
  /** Of outlines. */
  outline: ChainOutline | null;
}

/** What is known of an outline at each of its points. */
export interface ChainOutline {
  pieces: readonly LiftedPiece[];
  /** Half the width before a surface in place of the paper, pixels. */
  innerHalves: Float64Array;
  /** The share of a contour or a border times how much heavier an accent makes it. */
  accents: Float64Array;
  /** How much of it is a contour or a border before the paper: first as if all lay there, then as it lies. */
  contours: Float64Array;
  /** What is left of its width where edges are lost, as a share: first as if all lay before the paper, then as it lies. */
  lefts: Float64Array;
  /** Of a line of weight 1, pixels. */
  width: number;
  /** Of the bounding sphere, world units. */
  radius: number;
  /** Whether parts of the surface may be cut away. */
  isCutOut: boolean;
}

/** Collects the points of a chain. */
export class ChainBuilder {
  private readonly screen: number[] = [];
  private readonly world: number[] = [];
  private readonly halves: number[] = [];
  private readonly margins: number[] = [];
  private readonly triangles: number[] = [];
  private readonly field: number[] = [];
  private readonly shifts: number[] = [];

  get count(): number {
    return this.halves.length;
  }

  get hasLine(): boolean {
    return this.margins.some((margin) => margin > 0);
  }

  /** @param field of a line on a surface. @param shift of all points, or of none */
  push(
    screen: readonly number[],
    world: readonly number[],
    half: number,
    margin: number,
    triangle: number,
    field: readonly number[] = [],
    shift?: readonly [number, number],
  ): void {
    if (shift) this.shifts.push(...shift);
    this.screen.push(screen[0], screen[1]);
    this.world.push(world[0], world[1], world[2]);
    this.halves.push(half);
    this.margins.push(margin);
    this.triangles.push(triangle);
    this.field.push(...field);
  }

  /** Makes the last point what two triangles give in the mean, and the line go on over the second. */
  share(half: number, margin: number, triangle: number): void {
    const last = this.count - 1;
    this.halves[last] = 0.5 * (this.halves[last] + half);
    this.margins[last] = 0.5 * (this.margins[last] + margin);
    this.triangles[last] = triangle;
  }

  /** @param hash a number in [0, 1) that belongs to the line */
  finish(isClosed: boolean, hash = 0): Chain {
    return {
      count: this.count,
      screen: Float64Array.from(this.screen),
      world: Float64Array.from(this.world),
      halves: Float64Array.from(this.halves),
      margins: Float64Array.from(this.margins),
      triangles: Int32Array.from(this.triangles),
      shifts: this.shifts.length > 0 ? Float64Array.from(this.shifts) : null,
      isClosed,
      field: this.field.length > 0 ? Float64Array.from(this.field) : null,
      hash,
      outline: null,
    };
  }
}
