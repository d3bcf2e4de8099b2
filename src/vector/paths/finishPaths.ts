import { asPhase } from '../../mesh/phases.js';
import type { Projection } from '../Projection.js';
import { joinPaths } from './joinPaths.js';
import { type LinePath, PATH_STRIDE, pathLength, reversedPoints, simplify } from './LinePath.js';
import { asDrawn, type OrderedPath, orderPaths, type PathEnds, travelOf } from './orderPaths.js';
import { clipRing, type Ring, strokeOutline } from './strokeOutline.js';

/** Statistics of the paths of a drawing. Lengths in millimetres. */
export interface PathCounts {
  paths: number;
  points: number;
  travelBefore: number;
  travelAfter: number;
  drawn: number;
}

/** A path of the file. */
export interface WrittenPath {
  /** Path data, millimetres. */
  data: string;
  /** Its length, millimetres. */
  length: number;
  /** Where it begins, and where a pen is lifted after it, millimetres. */
  start: readonly [x: number, y: number];
  end: readonly [x: number, y: number];
  /** The vector from its first point to its last, millimetres. */
  way: readonly [dx: number, dy: number];
  /** The line of a pen, x and y of each point in millimetres; null for a filled path. A closed one does not repeat its first point. */
  line: { points: readonly number[]; isClosed: boolean } | null;
}

/** Precision of paths, millimetres. */
const TOLERANCE = 0.02;
/** Shorter filled paths are omitted, millimetres; of a pen, dashes shorter than two of its widths. */
const SHORTEST = 0.1;
const SHORTEST_DASH_IN_PENS = 2;
/** A pen goes on from one line to the next across gaps up to this one, millimetres. */
const JOINED = 0.1;

/** The way in which the paths of a layer are finished. Lengths in millimetres. */
export interface Finish {
  /** The width of the pen; null for filled outlines. */
  pen: number | null;
  /** Shorter lines of a pen are omitted. */
  shortest: number;
  order: 'travel' | 'drawn';
  placement: Placement;
}

/** Joins, simplifies, orders and writes the paths of a layer. Yields its progress. */
export function* finishPaths(
  paths: readonly LinePath[],
  { pen, shortest, order: wanted, placement }: Finish,
  projection: Projection,
): Generator<number, { written: WrittenPath[]; counts: PathCounts }, void> {
  const { scale, left, top } = placement;
  const leastOf = ({ isDash }: LinePath): number =>
    pen === null ? SHORTEST : isDash ? SHORTEST_DASH_IN_PENS * pen : shortest;
  const kept: LinePath[] = [];
  const joined = pen === null ? paths.filter(hasInk) : joinedInk(paths, scale);
  for (const [k, path] of joined.entries()) {
    if (k % 16 === 15) yield (0.3 * k) / joined.length;
    if (pathLength(path) * scale < leastOf(path)) continue;
    kept.push(simplify(path, TOLERANCE / scale));
  }
  const ends = kept.map((path) => endsOf(path, placement));
  const order = wanted === 'drawn' ? asDrawn(ends) : yield* asPhase(orderPaths(ends), 0.3, 0.7);
  const written: WrittenPath[] = [];
  const counts: PathCounts = {
    ...{ paths: 0, points: 0, drawn: 0 },
    travelBefore: travelOf(ends, asDrawn(ends)),
    travelAfter: travelOf(ends, order),
  };
  for (const [k, step] of order.entries()) {
    if (k % 16 === 15) yield 0.7 + (0.3 * k) / order.length;
    const { points, isClosed } = turned(kept[step.path], step);
    const xy = points.filter((_, i) => i % PATH_STRIDE < 2);
    const data =
      pen === null ? filledData({ points, isClosed }, projection, placement) : pathData(xy, isClosed, placement);
    if (data === '') continue;
    const onSheet = xy.map((value, i) => (i % 2 === 0 ? left : top) + scale * value);
    const start: WrittenPath['start'] = [onSheet[0], onSheet[1]];
    const last: WrittenPath['end'] = [onSheet[onSheet.length - 2], onSheet[onSheet.length - 1]];
    const length = pathLength({ points, isClosed }) * scale;
    written.push({
      ...{ data, length, start },
      end: isClosed ? start : last,
      way: [last[0] - start[0], last[1] - start[1]],
      line: pen === null ? null : { points: onSheet, isClosed },
    });
    counts.paths++;
    counts.points += points.length / PATH_STRIDE;
    counts.drawn += length;
  }
  return { written, counts };
}

/** The paths of a pen that can be drawn, joined where they go on in one another. scale: millimetres per pixel. */
export const joinedInk = (paths: readonly LinePath[], scale: number): LinePath[] =>
  joinPaths(paths.filter(hasInk), JOINED / scale);

/** Farther coordinates have lost their precision, pixels. */
const FARTHEST = 1e7;

/** Whether any of a path can be drawn. In a scene of infinite size positions may be NaN. */
const hasInk = ({ points }: LinePath): boolean =>
  points.some((value, i) => i % PATH_STRIDE > 1 && value > 0) && points.every((value) => Math.abs(value) < FARTHEST);

function endsOf({ points, isClosed }: LinePath, { scale, left, top }: Placement): PathEnds {
  const at = (o: number) => [left + scale * points[o], top + scale * points[o + 1]] as const;
  return { start: at(0), end: at(isClosed ? 0 : points.length - PATH_STRIDE) };
}

/** A path in its direction of drawing. */
const turned = (path: LinePath, { isReversed }: OrderedPath): LinePath =>
  isReversed ? { points: reversedPoints(path.points), isClosed: path.isClosed } : path;

/** The path data of the outline of a path; empty if nothing of it is drawn. */
const filledData = (path: LinePath, { width, height }: Projection, placement: Placement): string =>
  strokeOutline(path)
    .map((ring) => pathData(clipRing(ring, width, height), true, placement))
    .join('');

/** Coordinates are written in hundredths of a millimetre. */
const PER_MILLIMETRE = 100;

/** The placement of a picture on its sheet. */
export interface Placement {
  /** Millimetres per pixel. */
  scale: number;
  /** The upper left corner of the picture, millimetres. */
  left: number;
  top: number;
}

/** A number of hundredths, in its shortest form. */
function written(hundredths: number): string {
  const text = (hundredths / PER_MILLIMETRE).toFixed(2).replace(/\.?0+$/, '');
  return text.replace(/^(-?)0\./, '$1.') || '0';
}

/** The path data of a polyline; empty if all points are at one place. */
export function pathData(xy: Ring, isClosed: boolean, { scale, left, top }: Placement): string {
  const at = (i: number): readonly [number, number] => [
    Math.round((left + scale * xy[2 * i]) * PER_MILLIMETRE),
    Math.round((top + scale * xy[2 * i + 1]) * PER_MILLIMETRE),
  ];
  if (xy.length < 4) return '';
  let [x, y] = at(0);
  const first = `M${written(x)} ${written(y)}`;
  let steps = '';
  for (let i = 1; 2 * i < xy.length; i++) {
    const [nextX, nextY] = at(i);
    if (nextX === x && nextY === y) continue;
    const [dx, dy] = [written(nextX - x), written(nextY - y)];
    // A minus sign needs no space before it.
    steps += `${steps === '' ? 'l' : dx.startsWith('-') ? '' : ' '}${dx}${dy.startsWith('-') ? '' : ' '}${dy}`;
    [x, y] = [nextX, nextY];
  }
  return steps === '' ? '' : `${first}${steps}${isClosed ? 'z' : ''}`;
}
