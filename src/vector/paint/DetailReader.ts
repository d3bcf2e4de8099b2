import { combined, cross, dot, type Vec3, vectorAt } from '../../look/vectors.js';
import { FIELD, type LineSurface, STRIDE, VIEW, WORLD } from '../LineSurface.js';
import type { Mat3 } from '../shading/screenGradient.js';
import type { PosedMaps, SurfaceDetails } from './PaintLook.js';

/** Reads the details of a surface by the vertices that it had before subdivision. */
export class DetailReader {
  private triangle = -1;
  private place: PlaceInTriangle | undefined;
  private flat: Mat3 | undefined;
  /** The details at the place that was read last. */
  private at: Float64Array = new Float64Array(0);

  constructor(
    private readonly surface: LineSurface,
    private readonly details: SurfaceDetails,
  ) {}

  /** The details at a place of a triangle of the scene. */
  read(triangle: number, world: Vec3): Float64Array {
    const { corners, firstTriangle, stride, numbers } = this.details;
    this.goTo(triangle);
    const weights = this.place!.weightsAt(world);
    const c = 3 * (triangle - firstTriangle);
    this.at = interpolated(numbers, stride, [corners[c], corners[c + 1], corners[c + 2]], weights);
    return this.at;
  }

  /** The maps at the place that was read last; null for a surface that does not deform. */
  posedMaps(): PosedMaps | null {
    const { viewToField: o } = this.details;
    if (o === null) return null;
    this.flat ??= this.flatMap();
    return { smooth: [vectorAt(this.at, o), vectorAt(this.at, o + 3), vectorAt(this.at, o + 6)], flat: this.flat };
  }

  /** The products of the edges of a triangle, world space. */
  edgesOf(triangle: number): EdgeProducts {
    this.goTo(triangle);
    return this.place!;
  }

  /** The corners of a triangle, world space. */
  cornersOf(triangle: number): [Vec3, Vec3, Vec3] {
    this.goTo(triangle);
    return [this.corner(0, WORLD), this.corner(1, WORLD), this.corner(2, WORLD)];
  }

  private goTo(triangle: number): void {
    if (triangle === this.triangle) return;
    this.triangle = triangle;
    this.flat = undefined;
    this.place = new PlaceInTriangle(this.corner(0, WORLD), this.corner(1, WORLD), this.corner(2, WORLD));
  }

  private corner(k: number, offset: number): Vec3 {
    const { corners, firstTriangle } = this.details;
    const o = STRIDE * corners[3 * (this.triangle - firstTriangle) + k] + offset;
    return vectorAt(this.surface.vertices, o);
  }

  /** The linear map from the edges of the triangle in view space to those in field space, and from normal to normal. */
  private flatMap(): Mat3 {
    const [a, b, c] = [this.corner(0, VIEW), this.corner(1, VIEW), this.corner(2, VIEW)];
    const [ab, ac] = [combined(1, b, -1, a), combined(1, c, -1, a)];
    const normal = cross(ab, ac);
    const square = dot(normal, normal);
    if (!(square > 0)) return ZERO;
    // The dual basis of ab, ac and the normal: the components of a vector are its products with these.
    const [dualB, dualC] = [cross(ac, normal), cross(normal, ab)];
    const [p, q, r] = [this.corner(0, FIELD), this.corner(1, FIELD), this.corner(2, FIELD)];
    const [pq, pr] = [combined(1, q, -1, p), combined(1, r, -1, p)];
    const there = cross(pq, pr);
    return [0, 1, 2].map((k) =>
      combined(1 / square, combined(pq[k], dualB, pr[k], dualC), there[k] / square, normal),
    ) as unknown as Mat3;
  }
}

const ZERO: Mat3 = [
  [0, 0, 0],
  [0, 0, 0],
  [0, 0, 0],
];

/** The numbers at a place, from those of three vertices. stride: count of numbers per vertex. */
export function interpolated(numbers: ArrayLike<number>, stride: number, vertices: Vec3, weights: Vec3): Float64Array {
  const at = new Float64Array(stride);
  for (let k = 0; k < 3; k++) {
    const o = stride * vertices[k];
    for (let i = 0; i < stride; i++) at[i] += weights[k] * numbers[o + i];
  }
  return at;
}

/** Products of the two edges from the first corner of a triangle: of the first with itself, of both, and of the second with itself. */
export interface EdgeProducts {
  bb: number;
  bc: number;
  cc: number;
}

/** Barycentric coordinates in a triangle. */
export class PlaceInTriangle implements EdgeProducts {
  private readonly ab: Vec3;
  private readonly ac: Vec3;
  readonly bb: number;
  readonly bc: number;
  readonly cc: number;
  private readonly determinant: number;

  constructor(
    private readonly a: Vec3,
    b: Vec3,
    c: Vec3,
  ) {
    this.ab = combined(1, b, -1, a);
    this.ac = combined(1, c, -1, a);
    this.bb = dot(this.ab, this.ab);
    this.bc = dot(this.ab, this.ac);
    this.cc = dot(this.ac, this.ac);
    this.determinant = this.bb * this.cc - this.bc * this.bc;
  }

  /** Weights with a sum of 1, none below 0; for a triangle without area those of its first corner. */
  weightsAt(place: Vec3): Vec3 {
    if (!(this.determinant > 0)) return [1, 0, 0];
    const shares = this.sharesOf(combined(1, place, -1, this.a));
    const [v, w] = [Math.max(shares[0], 0), Math.max(shares[1], 0)];
    const rest = Math.max(1 - v - w, 0);
    const sum = rest + v + w;
    return [rest / sum, v / sum, w / sum];
  }

  /**
   * A vector in the plane as multiples of the edges from the first corner to the second and to the third; 0 for a triangle without area.
   */
  sharesOf(way: Vec3): readonly [number, number] {
    if (!(this.determinant > 0)) return [0, 0];
    const [b, c] = [dot(way, this.ab), dot(way, this.ac)];
    return [(this.cc * b - this.bc * c) / this.determinant, (this.bb * c - this.bc * b) / this.determinant];
  }
}
