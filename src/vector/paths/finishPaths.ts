import { asPhase } from '../../mesh/phases.js';
import type { DrawingPlan } from '../DrawnScene.js';
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
  /** Its length, and the vector from its start to its end, millimetres. */
  length: number;
  way: readonly [dx: number, dy: number];
}

/** Precision of paths, millimetres. */
const TOLERANCE = 0.02;
/** Shorter filled paths are omitted, millimetres; of a pen, dashes shorter than two of its widths. */
const SHORTEST = 0.1;
const SHORTEST_DASH_IN_PENS = 2;
/** A pen goes on from one line to the next across gaps up to this one, millimetres. */
const JOINED = 0.1;

/** Simplifies, orders and writes the paths of layers. Yields its progress. */
export function* finishPaths(
  layers: readonly { paths: readonly LinePath[] }[],
  plan: DrawingPlan,
  projection: Projection,
  placement: Placement,
): Generator<number, { written: WrittenPath[][]; counts: PathCounts }, void> {
  const counts: PathCounts = { paths: 0, points: 0, travelBefore: 0, travelAfter: 0, drawn: 0 };
  const written: WrittenPath[][] = [];
  const { scale } = placement;
  const { pen } = plan;
  const shortest = ({ isDash }: LinePath): number =>
    pen === null ? SHORTEST : isDash ? SHORTEST_DASH_IN_PENS * pen : plan.shortest;
  for (const [i, layer] of layers.entries()) {
    const kept: LinePath[] = [];
    const [from, to] = [i / layers.length, (i + 1) / layers.length];
    const inked = layer.paths.filter(hasInk);
    const joined = pen === null ? inked : joinPaths(inked, JOINED / scale);
    for (const [k, path] of joined.entries()) {
      if (k % 16 === 15) yield from + (0.3 * (to - from) * k) / joined.length;
      if (pathLength(path) * scale < shortest(path)) continue;
      kept.push(simplify(path, TOLERANCE / scale));
    }
    const ends = kept.map((path) => endsOf(path, placement));
    const order =
      plan.order === 'drawn'
        ? asDrawn(ends)
        : yield* asPhase(orderPaths(ends), from + 0.3 * (to - from), from + 0.7 * (to - from));
    counts.travelBefore += travelOf(ends, asDrawn(ends));
    counts.travelAfter += travelOf(ends, order);
    const done: WrittenPath[] = [];
    for (const [k, step] of order.entries()) {
      if (k % 16 === 15) yield from + (0.7 + (0.3 * k) / order.length) * (to - from);
      const path = turned(kept[step.path], step);
      const text = dataOf(path, plan, projection, placement);
      if (text === '') continue;
      const length = pathLength(path) * scale;
      const last = path.points.length - PATH_STRIDE;
      const way = [0, 1].map((axis) => scale * (path.points[last + axis] - path.points[axis]));
      done.push({ data: text, length, way: way as [number, number] });
      counts.paths++;
      counts.points += path.points.length / PATH_STRIDE;
      counts.drawn += length;
    }
    written.push(done);
  }
  return { written, counts };
}

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

/** The path data of a path; empty if nothing of it is drawn. */
function dataOf(path: LinePath, { pen }: DrawingPlan, { width, height }: Projection, placement: Placement): string {
  if (pen !== null)
    return pathData(
      path.points.filter((_, i) => i % PATH_STRIDE < 2),
      path.isClosed,
      placement,
    );
  return strokeOutline(path)
    .map((ring) => pathData(clipRing(ring, width, height), true, placement))
    .join('');
}

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
