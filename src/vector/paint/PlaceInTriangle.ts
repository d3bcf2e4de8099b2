import { combined, dot, type Vec3 } from '../../look/vectors.js';

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
