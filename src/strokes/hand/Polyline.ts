import type { HandStroke } from './Hand.js';

/** A stroke with the path length at every point. No two successive points coincide. */
export interface Polyline {
  x: Float64Array;
  y: Float64Array;
  width: Float64Array;
  /** The path length from the first point, in millimetres. */
  path: Float64Array;
}

/** The length of a vector. Unlike `Math.hypot` it is rounded the same on every machine, so that maps of a hand are identical. */
export const distance = (x: number, y: number): number => Math.sqrt(x * x + y * y);

/** The polyline of a stroke, without points that repeat the one before. */
export function polylineOf({ points, widths }: HandStroke): Polyline {
  const count = widths.length;
  const x = new Float64Array(count);
  const y = new Float64Array(count);
  const width = new Float64Array(count);
  const path = new Float64Array(count);
  let last = -1;
  for (let i = 0; i < count; i++) {
    const step = last < 0 ? 0 : distance(points[2 * i] - x[last], points[2 * i + 1] - y[last]);
    if (last >= 0 && step === 0) {
      // Repeated points keep the largest width.
      width[last] = Math.max(width[last], widths[i]);
      continue;
    }
    last++;
    x[last] = points[2 * i];
    y[last] = points[2 * i + 1];
    width[last] = widths[i];
    path[last] = last > 0 ? path[last - 1] + step : 0;
  }
  return part({ x, y, width, path }, 0, last);
}

/** The points `first` to `last` of a polyline. */
function part({ x, y, width, path }: Polyline, first: number, last: number): Polyline {
  const start = path[first];
  return {
    x: x.slice(first, last + 1),
    y: y.slice(first, last + 1),
    width: width.slice(first, last + 1),
    path: path.slice(first, last + 1).map((length) => length - start),
  };
}

/** The same path with `count` points at steady steps. */
export function resample(line: Polyline, count: number): Polyline {
  const x = new Float64Array(count);
  const y = new Float64Array(count);
  const width = new Float64Array(count);
  const path = new Float64Array(count);
  const last = line.path.length - 1;
  const total = line.path[last];
  let segment = 0;
  for (let i = 0; i < count; i++) {
    const place = (total * i) / (count - 1);
    while (segment < last - 1 && line.path[segment + 1] < place) segment++;
    const from = Math.min(segment, last);
    const to = Math.min(segment + 1, last);
    const step = line.path[to] - line.path[from];
    const share = step > 0 ? Math.min(1, (place - line.path[from]) / step) : 0;
    x[i] = line.x[from] + share * (line.x[to] - line.x[from]);
    y[i] = line.y[from] + share * (line.y[to] - line.y[from]);
    width[i] = line.width[from] + share * (line.width[to] - line.width[from]);
    path[i] = place;
  }
  return { x, y, width, path };
}

/** The mean width along a polyline. */
function meanWidth({ width, path }: Polyline): number {
  const last = path.length - 1;
  if (last < 1) return width[0];
  let sum = 0;
  for (let i = 1; i <= last; i++) sum += 0.5 * (width[i] + width[i - 1]) * (path[i] - path[i - 1]);
  return sum / path[last];
}

/** The cosine of the largest angle between a stroke and its direction so far: 80 degrees. */
const TURN = 0.17;

/** The tremor of a hand, in millimetres. Shorter detours are no turns. */
const TREMOR = 0.5;

/** A piece shorter than this many widths is a dot or a hook. */
const SHORTEST = 1.5;

/**
 * Splits a stroke where it turns back, as in a scribble drawn without lifting the pen. Every piece runs forward along its chord, so that
 * its bends are distances from the chord. Dots, and hooks at the ends, are left out.
 */
export function splitAtTurns(line: Polyline): Polyline[] {
  const count = line.path.length;
  if (count < 2) return [];
  const width = meanWidth(line);
  const reach = Math.min(Math.max(1.5 * width, TREMOR), 0.25 * line.path[count - 1]);
  const pieces: Polyline[] = [];
  let start = 0;
  let farthest = 0;
  let farthestWay = 0;
  let before = 0;
  let after = 0;
  const add = (end: number): void => {
    const piece = part(line, start, end);
    const last = end - start;
    if (last > 0 && distance(piece.x[last] - piece.x[0], piece.y[last] - piece.y[0]) > SHORTEST * meanWidth(piece))
      pieces.push(piece);
  };
  for (let i = 1; i < count; i++) {
    const way = distance(line.x[i] - line.x[start], line.y[i] - line.y[start]);
    if (way > farthestWay) {
      farthestWay = way;
      farthest = i;
    }
    while (line.path[i] - line.path[before] > reach) before++;
    while (after < count - 1 && line.path[after] - line.path[i] < reach) after++;
    if (farthestWay < 2 * reach || before < start) continue;
    const dx = line.x[after] - line.x[before];
    const dy = line.y[after] - line.y[before];
    const forward = dx * (line.x[farthest] - line.x[start]) + dy * (line.y[farthest] - line.y[start]);
    if (forward >= TURN * farthestWay * distance(dx, dy)) continue;
    // The turn may lie a little ahead: go on to the point farthest away.
    while (
      farthest < count - 1 &&
      distance(line.x[farthest + 1] - line.x[start], line.y[farthest + 1] - line.y[start]) > farthestWay
    ) {
      farthest++;
      farthestWay = distance(line.x[farthest] - line.x[start], line.y[farthest] - line.y[start]);
    }
    add(farthest);
    start = farthest;
    i = farthest;
    before = farthest;
    after = farthest;
    farthestWay = 0;
  }
  add(count - 1);
  return pieces;
}
