import { asPhase } from '../mesh/phases.js';
import { GrowingArray } from './GrowingArray.js';
import { cornersOf, FIELD, type LineSurface, onPicture, STRIDE, VIEW, WORLD } from './LineSurface.js';
import type { Projection } from './Projection.js';

/**
 * Length of edges on the picture above which they are halved, pixels; and a shorter length above which they are halved if longer than so
 * many tiles.
 */
const LONGEST = 24;
const SHORTEST_HALVED = 4;
const LONGEST_TILES = 0.12;
/** Enough for an edge of 4,000 times the greatest length. */
const MOST_PASSES = 12;
/** Number of halvings at the near plane, which cut off what lies before it. */
const PASSES_AT_NEAR_PLANE = 7;

const pairOf = (a: number, b: number): number => (a < b ? a * 2 ** 26 + b : b * 2 ** 26 + a);

/** Places on the picture, and whether they lie before the near plane. */
interface Seen {
  x: Float64Array;
  y: Float64Array;
  isBefore: Uint8Array;
}

function* seenPlaces(surface: LineSurface, projection: Projection, count: number): Generator<number, Seen, void> {
  const { vertices, placeOf } = surface;
  const seen = { x: new Float64Array(count), y: new Float64Array(count), isBefore: new Uint8Array(count) };
  for (let v = 0; v < placeOf.length; v++) {
    if (v % 8192 === 8191) yield v / placeOf.length;
    const [x, y] = onPicture(surface, v, projection);
    seen.x[placeOf[v]] = x;
    seen.y[placeOf[v]] = y;
    seen.isBefore[placeOf[v]] = Number(-vertices[STRIDE * v + VIEW + 2] < projection.camera.near);
  }
  return seen;
}

/** Whether a triangle may be visible on the picture. */
function mayBeSeen({ x, y, isBefore }: Seen, { width, height }: Projection, a: number, b: number, c: number): boolean {
  const before = isBefore[a] + isBefore[b] + isBefore[c];
  if (before > 0) return before < 3;
  return (
    Math.max(x[a], x[b], x[c]) >= 0 &&
    Math.min(x[a], x[b], x[c]) <= width &&
    Math.max(y[a], y[b], y[c]) >= 0 &&
    Math.min(y[a], y[b], y[c]) <= height
  );
}

/** One pass over a surface: every long edge that may be visible is halved, in the same way for both of its triangles. */
class Halving {
  /** The new place between two places, and the new vertex between two vertices. */
  private readonly middles = new Map<number, number>();
  private readonly halves = new Map<number, number>();
  private readonly triangles: GrowingArray<Int32Array>;
  private readonly parents: GrowingArray<Int32Array>;
  private places: number;

  constructor(
    private readonly surface: LineSurface,
    private readonly vertices: GrowingArray<Float64Array>,
    private readonly placeOf: GrowingArray<Int32Array>,
    private readonly projection: Projection,
    placeCount: number,
    private readonly pass: number,
    private readonly seen: Seen,
  ) {
    this.places = placeCount;
    this.triangles = new GrowingArray(new Int32Array(surface.triangles.length), 0);
    this.parents = new GrowingArray(new Int32Array(surface.parents.length), 0);
  }

  /** Returns the number of places, or −1 if no edge was halved. Yields its progress. */
  *run(): Generator<number, number, void> {
    const { surface, seen, projection } = this;
    const { triangles, parents, placeOf } = surface;
    for (let t = 0; 3 * t < triangles.length; t++) {
      if (t % 1024 === 1023) yield (3 * t) / triangles.length;
      const [a, b, c] = cornersOf(surface, t);
      // Invisible triangles are dropped.
      if (!mayBeSeen(seen, projection, placeOf[a], placeOf[b], placeOf[c])) continue;
      this.split(parents[t], a, b, c);
    }
    surface.vertices = this.vertices.used();
    surface.placeOf = this.placeOf.used();
    surface.triangles = this.triangles.used();
    surface.parents = this.parents.used();
    return this.halves.size > 0 ? this.places : -1;
  }

  private add(parent: number, ...corners: number[]): void {
    for (const corner of corners) this.triangles.push(corner);
    for (let i = 0; i < corners.length; i += 3) this.parents.push(parent);
  }

  private split(parent: number, a: number, b: number, c: number): void {
    const [d, e, f] = [this.middleOf(a, b), this.middleOf(b, c), this.middleOf(c, a)];
    const count = Number(d >= 0) + Number(e >= 0) + Number(f >= 0);
    if (count === 0) this.add(parent, a, b, c);
    else if (count === 3) this.add(parent, a, d, f, d, b, e, f, e, c, d, e, f);
    else if (count === 1) {
      if (d >= 0) this.add(parent, a, d, c, d, b, c);
      else if (e >= 0) this.add(parent, b, e, a, e, c, a);
      else this.add(parent, c, f, b, f, a, b);
    } else if (d < 0) this.add(parent, e, c, f, a, b, e, a, e, f);
    else if (e < 0) this.add(parent, a, d, f, d, b, c, d, c, f);
    else this.add(parent, d, b, e, a, d, e, a, e, c);
  }

  private isLong(a: number, b: number, va: number, vb: number): boolean {
    const { x, y, isBefore } = this.seen;
    if (isBefore[a] !== isBefore[b]) return this.pass < PASSES_AT_NEAR_PLANE;
    if (isBefore[a]) return false;
    const pixels = Math.hypot(x[a] - x[b], y[a] - y[b]);
    if (pixels <= SHORTEST_HALVED) return false;
    if (pixels > LONGEST) return true;
    const vertices = this.vertices.data;
    const [i, j] = [STRIDE * va + FIELD, STRIDE * vb + FIELD];
    return (
      Math.hypot(vertices[i] - vertices[j], vertices[i + 1] - vertices[j + 1], vertices[i + 2] - vertices[j + 2]) >
      LONGEST_TILES
    );
  }

  /** The vertex in the middle of an edge, or −1 if the edge is short. */
  private middleOf(u: number, v: number): number {
    const { placeOf, vertices } = this;
    const [a, b] = [placeOf.data[u], placeOf.data[v]];
    if (!this.isLong(a, b, u, v)) return -1;
    const pair = pairOf(u, v);
    const known = this.halves.get(pair);
    if (known !== undefined) return known;
    const key = pairOf(a, b);
    const other = this.middles.get(key);
    const vertex = placeOf.length;
    // From the lower to the higher index, or the two sides of the edge would round differently.
    const [from, to] = a < b ? [STRIDE * u, STRIDE * v] : [STRIDE * v, STRIDE * u];
    vertices.reserve(STRIDE * (vertex + 1));
    const numbers = vertices.data;
    for (let k = 0; k < STRIDE; k++) vertices.push(0.5 * (numbers[from + k] + numbers[to + k]));
    if (other === undefined) {
      this.middles.set(key, vertex);
      placeOf.push(this.places++);
    } else {
      placeOf.push(placeOf.data[other]);
      for (let k = WORLD; k < FIELD + 3; k++) numbers[STRIDE * vertex + k] = numbers[STRIDE * other + k];
    }
    this.halves.set(pair, vertex);
    return vertex;
  }
}

/**
 * Halves the long edges of a surface, so that widths and values are nearly linear over each triangle, and drops triangles that are not
 * visible on the picture. Changes the surface. Yields its progress.
 */
export function* subdivide(surface: LineSurface, projection: Projection): Generator<number, void, void> {
  const vertices = new GrowingArray(surface.vertices);
  const placeOf = new GrowingArray(surface.placeOf);
  let places = 0;
  for (let v = 0; v < placeOf.length; v++) places = Math.max(places, 1 + placeOf.data[v]);
  yield 0;
  for (let pass = 0; pass < MOST_PASSES && places >= 0; pass++) {
    // Each pass gets half of the remaining progress.
    const [from, to] = [1 - 0.5 ** pass, 1 - 0.5 ** (pass + 1)];
    const seen = yield* asPhase(seenPlaces(surface, projection, places), from, (from + to) / 2);
    places = yield* asPhase(
      new Halving(surface, vertices, placeOf, projection, places, pass, seen).run(),
      (from + to) / 2,
      to,
    );
  }
}
