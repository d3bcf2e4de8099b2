import type { LiftedPiece } from './shading/outlines.js';

/** A polyline on a surface. A closed one ends with its first point. */
export interface Chain {
  count: number;
  /** Pixels of the picture: two numbers per point. */
  screen: Float64Array;
  /** World space: three numbers per point. */
  world: Float64Array;
  /** Half the width at each point, pixels. */
  halves: Float64Array;
  /** Above 0 where there is a line, linear between points. */
  margins: Float64Array;
  /** The triangle of the scene under the piece after each point; −1 for edges. */
  triangles: Int32Array;
  /** Offsets of the middle of the line from the points, pixels of the picture: two numbers per point; null for none. */
  shifts: Float64Array | null;
  isClosed: boolean;
  /** Field space: three numbers per point of a line on a surface; null for others. */
  field: Float64Array | null;
  /** A hash of the line in [0, 1). */
  hash: number;
  /** Null for lines on surfaces. */
  outline: ChainOutline | null;
}

/** Properties of an outline at one of its points. */
export interface OutlinePoint extends LiftedPiece {
  /** Half the width before a surface instead of paper, pixels. */
  innerHalf: number;
  /** The extra weight of an accent, times the share of the outline that is a contour or a border. */
  accent: number;
  /** The share that is a contour or a border before paper: first as if all lay before paper, then as it lies. */
  contour: number;
  /** The share of its width that is left where edges are lost: first as if all lay before paper, then as it lies. */
  left: number;
}

/** Properties of an outline. */
export interface ChainOutline {
  points: readonly OutlinePoint[];
  /** Width at weight 1, pixels. */
  width: number;
  /** Radius of the bounding sphere, world units. */
  radius: number;
  /** Whether parts of the surface may be cut out. */
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

  /** @param field field space, for lines on surfaces. @param shift offset of the line; for all points of a chain, or for none */
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

  /** Sets the last point to the mean of what two triangles give, and continues the line over the second. */
  share(half: number, margin: number, triangle: number, shift?: readonly [number, number]): void {
    const last = this.count - 1;
    if (shift) for (const k of [0, 1]) this.shifts[2 * last + k] = 0.5 * (this.shifts[2 * last + k] + shift[k]);
    this.halves[last] = 0.5 * (this.halves[last] + half);
    this.margins[last] = 0.5 * (this.margins[last] + margin);
    this.triangles[last] = triangle;
  }

  /** Continues with the points of another chain that begins where this one ends. */
  append({ screen, world, halves, margins, triangles, field, shifts }: ChainBuilder): void {
    for (const [own, others] of [
      [this.screen, screen],
      [this.world, world],
      [this.halves, halves],
      [this.margins, margins],
      [this.triangles, triangles],
      [this.field, field],
      [this.shifts, shifts],
    ])
      for (const value of others) own.push(value);
  }

  /** @param hash a hash of the line in [0, 1) */
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
