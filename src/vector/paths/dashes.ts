import { type LinePath, PATH_STRIDE, pathLength } from './LinePath.js';

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
  const walk = new PathWalk(path);
  return Array.from({ length: count }, (_, i) => ({
    points: walk.between(i * stretch, i * stretch + on),
    isClosed: false,
  }));
}

/** A walk along a path from its start. */
class PathWalk {
  private readonly points: readonly number[];
  /** The distance of each point from the start. */
  private readonly places: number[] = [0];
  private piece = 0;

  constructor({ points, isClosed }: LinePath) {
    this.points = isClosed ? [...points, ...points.slice(0, PATH_STRIDE)] : points;
    for (let o = PATH_STRIDE; o < this.points.length; o += PATH_STRIDE) {
      const [dx, dy] = [
        this.points[o] - this.points[o - PATH_STRIDE],
        this.points[o + 1] - this.points[o - PATH_STRIDE + 1],
      ];
      this.places.push(this.places[this.places.length - 1] + Math.hypot(dx, dy));
    }
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
    return Array.from({ length: PATH_STRIDE }, (_, k) => {
      const [a, b] = [points[o + k], points[o + PATH_STRIDE + k]];
      return a + share * (b - a);
    });
  }
}
