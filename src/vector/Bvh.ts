import type { Vec3 } from '../look/vectors.js';
import { asPhase, forEachChunk } from '../mesh/phases.js';
import { type BvhNodes, buildBvh } from './buildBvh.js';
import { Holes } from './paint/Holes.js';
import type { Cutout } from './paint/PaintLook.js';

/** Bits of a triangle: which sides are visible, and which cast shadows. On the front side corners run counter-clockwise. */
export const SEEN_FRONT = 1;
export const SEEN_BACK = 2;
export const CASTS_FRONT = 4;
export const CASTS_BACK = 8;
/** Set for triangles that may have holes. */
export const MAY_HAVE_HOLES = 16;
/** The sides of a see-through surface, which fade what is behind them instead of hiding it. */
export const FADES_FRONT = 32;
const FADES_BACK = 64;

/** Depth of the traversal stack, enough for any number of triangles that fits into memory. */
const STACK = 256;
const NO_TRIANGLE = -1;
/** The share of building after which triangles are copied into leaf order. */
const SORTED_FROM = 0.9;

/** A bounding volume hierarchy over the triangles of a scene, for ray queries. */
export class Bvh {
  /** Nine numbers per triangle, in leaf order. */
  private readonly sorted: Float64Array;
  private readonly sortedSides: Uint8Array;
  private readonly stack = new Int32Array(STACK);
  /** Distances of the boxes on the traversal stack. */
  private readonly nears = new Float64Array(STACK);
  /** The triangle that was hit last, which the next ray most likely hits too. */
  private lastMet = 0;
  /** The current ray. */
  private readonly origin = new Float64Array(3);
  private readonly direction = new Float64Array(3);
  private readonly inverse = new Float64Array(3);
  /** Bits of the sides that count as hits, for the front and for the back of a triangle. */
  private ofFront = 0;
  private ofBack = 0;
  /** Number of rays so far. */
  rays = 0;
  /** The greatest absolute coordinate. */
  extent = 0;

  private constructor(
    private readonly nodes: BvhNodes,
    private readonly holes: Holes,
  ) {
    this.sorted = new Float64Array(9 * nodes.order.length);
    this.sortedSides = new Uint8Array(nodes.order.length);
  }

  /**
   * Builds the hierarchy over triangles.
   *
   * @param corners nine numbers per triangle, world space
   * @param sides bits per triangle
   * @param cutouts ranges of triangles with holes
   */
  static *build(
    corners: Float64Array,
    sides: Uint8Array,
    cutouts: readonly Cutout[] = [],
  ): Generator<number, Bvh, void> {
    const nodes = yield* asPhase(buildBvh(corners), 0, SORTED_FROM);
    const bvh = new Bvh(nodes, new Holes(cutouts));
    yield* asPhase(
      forEachChunk(sides.length, (start, end) => bvh.sort(corners, sides, start, end)),
      SORTED_FROM,
      1,
    );
    return bvh;
  }

  /** Copies triangles into leaf order. */
  private sort(corners: Float64Array, sides: Uint8Array, start: number, end: number): void {
    const { sorted, sortedSides } = this;
    const { order } = this.nodes;
    for (let i = start; i < end; i++) {
      const from = 9 * order[i];
      for (let k = 0; k < 9; k++) {
        const number = corners[from + k];
        sorted[9 * i + k] = number;
        if (Math.abs(number) > this.extent) this.extent = Math.abs(number);
      }
      sortedSides[i] = sides[order[i]];
    }
  }

  /**
   * Whether anything visible lies between origin + start · way and origin + end · way, for an eye at the far end.
   *
   * @param except a triangle to ignore
   */
  isHidden(origin: Vec3, way: Vec3, start: number, end: number, except = NO_TRIANGLE): boolean {
    // From the far end, the front of a triangle that the ray hits from behind is visible.
    this.setRay(origin, way, SEEN_BACK, SEEN_FRONT);
    return this.meetsAny(start, end, except);
  }

  /** Whether anything that casts shadows lies there, for a light at the far end. */
  isShaded(origin: Vec3, way: Vec3, start: number, end: number): boolean {
    this.setRay(origin, way, CASTS_BACK, CASTS_FRONT);
    return this.meetsAny(start, end, NO_TRIANGLE);
  }

  /**
   * Calls back for each triangle of a see-through surface on the way to an eye at the far end.
   *
   * @param meet called with the triangle and its distance along the way
   */
  eachFading(
    origin: Vec3,
    way: Vec3,
    start: number,
    end: number,
    except: number,
    meet: (triangle: number, place: number) => void,
  ): void {
    this.setRay(origin, way, FADES_BACK, FADES_FRONT);
    this.meet(start, end, except, false, meet);
  }

  /** The distance along a ray of light, up to `end`, of the first hit that casts shadows; Infinity for none. */
  firstCaster(origin: Vec3, way: Vec3, end: number): number {
    this.setRay(origin, way, CASTS_FRONT, CASTS_BACK);
    return this.meet(0, end, NO_TRIANGLE, false);
  }

  /** The distance along a ray from an eye, beyond `start`, of the first visible hit; Infinity for none. */
  firstMet(origin: Vec3, way: Vec3, start: number): number {
    this.setRay(origin, way, SEEN_FRONT, SEEN_BACK);
    return this.meet(start, Infinity, NO_TRIANGLE, false);
  }

  private setRay(origin: Vec3, way: Vec3, ofFront: number, ofBack: number): void {
    this.rays++;
    for (let a = 0; a < 3; a++) {
      this.origin[a] = origin[a];
      this.direction[a] = way[a];
      this.inverse[a] = 1 / way[a];
    }
    this.ofFront = ofFront;
    this.ofBack = ofBack;
  }

  /** Whether the ray hits anything within (start, end) except one triangle. */
  private meetsAny(start: number, end: number, except: number): boolean {
    const { lastMet, sorted } = this;
    if (sorted.length === 0) return false;
    if (this.nodes.order[lastMet] !== except) {
      const t = this.meetsTriangle(lastMet);
      if (t > start && t < end) return true;
    }
    return this.meet(start, end, except, true) < Infinity;
  }

  /** The distance of the nearest hit within (start, end), or of any hit. onHit: called for all hits, in no particular order. */
  private meet(
    start: number,
    end: number,
    except: number,
    isAnyEnough: boolean,
    onHit?: (triangle: number, place: number) => void,
  ): number {
    const { stack, nears, sorted } = this;
    const { child, leafCount, order } = this.nodes;
    let best = Infinity;
    let far = end;
    let top = 0;
    if (sorted.length > 0) {
      nears[0] = start;
      stack[top++] = 0;
    }
    while (top > 0) {
      const node = stack[--top];
      if (nears[top] > far) continue;
      const first = child[node];
      const count = leafCount[node];
      for (let i = first; i < first + count; i++) {
        const t = this.meetsTriangle(i);
        if (!(t > start && t < far) || order[i] === except) continue;
        if (isAnyEnough) {
          this.lastMet = i;
          return t;
        }
        if (onHit) onHit(order[i], t);
        else best = far = t;
      }
      if (count > 0) continue;
      const left = this.entersBox(6 * first, start, far);
      const right = this.entersBox(6 * first + 6, start, far);
      // The nearer child is visited first.
      const isLeftFirst = left <= right;
      if (isLeftFirst && right < Infinity) {
        nears[top] = right;
        stack[top++] = first + 1;
      }
      if (left < Infinity) {
        nears[top] = left;
        stack[top++] = first;
      }
      if (!isLeftFirst && right < Infinity) {
        nears[top] = right;
        stack[top++] = first + 1;
      }
    }
    return best;
  }

  /** The distance at which the ray enters a box; Infinity if it does not. */
  private entersBox(box: number, start: number, end: number): number {
    const { bounds } = this.nodes;
    const { origin, inverse } = this;
    let near = start;
    let far = end;
    for (let a = 0; a < 3; a++) {
      const t0 = (bounds[box + a] - origin[a]) * inverse[a];
      const t1 = (bounds[box + 3 + a] - origin[a]) * inverse[a];
      // 0 · ∞ is NaN, and keeps the other bound.
      if (t0 < t1) {
        if (t0 > near) near = t0;
        if (t1 < far) far = t1;
      } else {
        if (t1 > near) near = t1;
        if (t0 < far) far = t0;
      }
    }
    // Boxes are slightly larger than their contents, but at a great distance rounding errors are larger.
    return near <= far + 1e-12 * Math.abs(far) ? near : Infinity;
  }

  /** The distance of a hit with a triangle, if the side that faces the ray counts (Möller and Trumbore, 1997); otherwise NaN. */
  private meetsTriangle(i: number): number {
    const c = this.sorted;
    const o = 9 * i;
    const dx = this.direction[0];
    const dy = this.direction[1];
    const dz = this.direction[2];
    const e1x = c[o + 3] - c[o];
    const e1y = c[o + 4] - c[o + 1];
    const e1z = c[o + 5] - c[o + 2];
    const e2x = c[o + 6] - c[o];
    const e2y = c[o + 7] - c[o + 1];
    const e2z = c[o + 8] - c[o + 2];
    const px = dy * e2z - dz * e2y;
    const py = dz * e2x - dx * e2z;
    const pz = dx * e2y - dy * e2x;
    // Minus n·d: above 0 where the ray hits the front.
    const determinant = e1x * px + e1y * py + e1z * pz;
    const counted = determinant > 0 ? this.ofFront : this.ofBack;
    if (determinant === 0 || (this.sortedSides[i] & counted) === 0) return Number.NaN;
    const sx = this.origin[0] - c[o];
    const sy = this.origin[1] - c[o + 1];
    const sz = this.origin[2] - c[o + 2];
    const u = (sx * px + sy * py + sz * pz) / determinant;
    if (!(u >= 0 && u <= 1)) return Number.NaN;
    const qx = sy * e1z - sz * e1y;
    const qy = sz * e1x - sx * e1z;
    const qz = sx * e1y - sy * e1x;
    const v = (dx * qx + dy * qy + dz * qz) / determinant;
    if (!(v >= 0 && u + v <= 1)) return Number.NaN;
    const t = (e2x * qx + e2y * qy + e2z * qz) / determinant;
    return (this.sortedSides[i] & MAY_HAVE_HOLES) !== 0 && this.isOpen(i, u, v, t) ? Number.NaN : t;
  }

  private isOpen(i: number, u: number, v: number, t: number): boolean {
    const { origin: o, direction: d } = this;
    const place: Vec3 = [o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]];
    return this.holes.isOpen(this.nodes.order[i], u, v, place, (this.ofFront & (CASTS_FRONT | CASTS_BACK)) !== 0);
  }
}
