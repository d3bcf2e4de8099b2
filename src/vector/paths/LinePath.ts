import { clamp01, mix } from '../../look/vectors.js';

/** Numbers per point of a path: x, y, and half the width on its left and on its right, pixels of the picture. */
export const PATH_STRIDE = 4;

/** A polyline with widths. */
export interface LinePath {
  /** `PATH_STRIDE` numbers per point. A closed path does not repeat its first point. */
  points: readonly number[];
  isClosed: boolean;
  /** Whether it is one of the dashes of a line. */
  isDash?: boolean;
}

/** The points of a path in reverse, with left and right exchanged. */
export function reversedPoints(points: readonly number[]): number[] {
  const reversed: number[] = [];
  for (let o = points.length - PATH_STRIDE; o >= 0; o -= PATH_STRIDE)
    reversed.push(points[o], points[o + 1], points[o + 3], points[o + 2]);
  return reversed;
}

/** The points of a path; those of a closed one end where they begin. */
const unrolled = ({ points, isClosed }: LinePath): readonly number[] =>
  isClosed ? [...points, ...points.slice(0, PATH_STRIDE)] : points;

/** The distance of each point of a path from its start, pixels; of a closed path also that of its first point, reached again. */
function distancesAlong(path: LinePath): number[] {
  const points = unrolled(path);
  const distances = [0];
  for (let o = PATH_STRIDE; o < points.length; o += PATH_STRIDE) {
    const step = Math.hypot(points[o] - points[o - PATH_STRIDE], points[o + 1] - points[o - PATH_STRIDE + 1]);
    distances.push(distances[distances.length - 1] + step);
  }
  return distances;
}

/** Length of a path, pixels. */
export const pathLength = (path: LinePath): number => distancesAlong(path).pop()!;

/**
 * Cuts a path into dashes, with one at each end, and gaps between them. Both are stretched equally until they fit; a path hardly longer
 * than a dash stays whole.
 *
 * @param dash and `gap` in pixels
 */
export function dashes(path: LinePath, dash: number, gap: number): LinePath[] {
  const length = pathLength(path);
  const count = Math.round((length + gap) / (dash + gap));
  if (count < 2) return [path];
  const period = (length + gap) / count;
  const on = (dash * period) / (dash + gap);
  const stretch = (length - on) / (count - 1);
  const spans = Array.from({ length: count }, (_, i): Span => [i * stretch, i * stretch + on]);
  return piecesOf(path, spans).map((piece) => ({ ...piece, isDash: true }));
}

/** Start and end of a piece of a path, as distances from its start, pixels. */
export type Span = readonly [from: number, to: number];

/** The pieces of a path at spans in rising order. */
export function piecesOf(path: LinePath, spans: readonly Span[]): LinePath[] {
  const walk = new PathWalk(path);
  return spans.map(([from, to]) => ({ points: walk.between(from, to), isClosed: false }));
}

/** Calls a function for places along a path, at most so far apart: x, y, the direction as a unit vector, and the distance from its start, pixels. */
export function alongPath(
  path: LinePath,
  apart: number,
  visit: (x: number, y: number, dx: number, dy: number, place: number) => void,
): void {
  const points = unrolled(path);
  let place = 0;
  for (let o = PATH_STRIDE; o < points.length; o += PATH_STRIDE) {
    const [x, y] = [points[o - PATH_STRIDE], points[o - PATH_STRIDE + 1]];
    const [dx, dy] = [points[o] - x, points[o + 1] - y];
    const length = Math.hypot(dx, dy);
    const steps = Math.ceil(length / apart);
    for (let k = 0; k < steps; k++) {
      const share = (k + 0.5) / steps;
      visit(x + share * dx, y + share * dy, dx / length, dy / length, place + share * length);
    }
    place += length;
  }
}

/** A walk along a path from its start. */
class PathWalk {
  private readonly points: readonly number[];
  private readonly places: readonly number[];
  private piece = 0;

  constructor(path: LinePath) {
    this.points = unrolled(path);
    this.places = distancesAlong(path);
  }

  /** The points from one distance to another, in rising order from call to call. */
  between(from: number, to: number): number[] {
    const found = this.at(from);
    while (this.piece + 2 < this.places.length && this.places[this.piece + 1] < to) {
      this.piece++;
      found.push(...this.points.slice(PATH_STRIDE * this.piece, PATH_STRIDE * (this.piece + 1)));
    }
    found.push(...this.at(to));
    return found;
  }

  private at(place: number): number[] {
    const { places, points } = this;
    while (this.piece + 2 < places.length && places[this.piece + 1] < place) this.piece++;
    const [start, end] = [places[this.piece], places[this.piece + 1]];
    const share = end > start ? Math.min((place - start) / (end - start), 1) : 0;
    const o = PATH_STRIDE * this.piece;
    return Array.from({ length: PATH_STRIDE }, (_, k) => mix(points[o + k], points[o + PATH_STRIDE + k], share));
  }
}

/** Removes points of a path that change neither place nor width by more than the tolerance, pixels (Douglas and Peucker, 1973). */
export function simplify(path: LinePath, tolerance: number): LinePath {
  const { isClosed } = path;
  const all = unrolled(path);
  const count = all.length / PATH_STRIDE;
  if (count <= 2) return path;
  const keeps = new Uint8Array(count);
  keeps[0] = keeps[count - 1] = 1;
  const stack: (readonly [number, number])[] = [[0, count - 1]];
  for (let range = stack.pop(); range; range = stack.pop()) {
    const worst = worstBetween(all, range[0], range[1], tolerance);
    if (worst < 0) continue;
    keeps[worst] = 1;
    stack.push([range[0], worst], [worst, range[1]]);
  }
  const kept: number[] = [];
  for (let i = 0; i < count - Number(isClosed); i++) {
    if (keeps[i] === 1) kept.push(...all.slice(PATH_STRIDE * i, PATH_STRIDE * (i + 1)));
  }
  return { points: kept, isClosed: isClosed && kept.length > 2 * PATH_STRIDE };
}

/** The point farthest from the straight line between two; −1 if all lie within the tolerance. */
function worstBetween(points: readonly number[], first: number, last: number, tolerance: number): number {
  const [a, b] = [PATH_STRIDE * first, PATH_STRIDE * last];
  const [dx, dy] = [points[b] - points[a], points[b + 1] - points[a + 1]];
  const square = dx * dx + dy * dy;
  let [most, worst] = [tolerance, -1];
  for (let i = first + 1; i < last; i++) {
    const o = PATH_STRIDE * i;
    const [x, y] = [points[o] - points[a], points[o + 1] - points[a + 1]];
    const t = square > 0 ? clamp01((x * dx + y * dy) / square) : 0;
    let off = Math.hypot(x - t * dx, y - t * dy);
    for (const side of [2, 3]) {
      const width = mix(points[a + side], points[b + side], t);
      off = Math.max(off, Math.abs(points[o + side] - width));
    }
    if (off > most) [most, worst] = [off, i];
  }
  return worst;
}
