import type { Dot, DotLayer } from '../drawDots.js';
import type { PathLayer, PenWidths } from '../LineDrawer.js';
import { alongPath, type LinePath, pathLength, piecesOf, type Span } from '../paths/LinePath.js';
import { PassMap } from './PassMap.js';
import { partOfLayer } from './pens.js';

/** Distance of the places on a line that are looked at, in widths of its pen. */
const APART = 1 / 4;
/** A line is full where more than this share of its width has all passes; or any of it, and more than this share over so many places on both sides. */
const MOST_OF_WIDTH = 0.5;
const MOST_AROUND = 0.15;
const AROUND = 16;
/** Shorter pieces that are left of a line are not drawn, in widths of the pen. */
const SHORTEST = 5;
/** Between two long pieces, a line goes on over a place so short: a gap would cost a lift. In widths of the pen. */
const BRIDGED = 1.5;
const LONG = 10;
/** Of a dot that is drawn, at most this share has all its passes already. */
const DOT_SHARE = 0.1;

/** What a limit of passes depends on. Lengths in pixels of the picture. */
interface PassLimit {
  /** The greatest number of times that pens pass over a place. */
  passes: number;
  widthOf: PenWidths;
  /** Shorter lines are not drawn, except for dashes. */
  shortest: number;
  /** The size of the picture. */
  width: number;
  height: number;
}

/** The lines and dots of a drawing. */
export interface Penned {
  lines: readonly PathLayer[];
  dots: readonly DotLayer[];
}

/**
 * Cuts lines of pens, and leaves out dots, where pens have passed often enough, so that paper gets no wetter. Layers count in their order, those
 * before have precedence. Yields its progress.
 */
export function* limitPasses(
  { lines, dots }: Penned,
  { passes, widthOf, shortest, width, height }: PassLimit,
): Generator<number, Penned, void> {
  const penOfLines = ({ name, ink }: PathLayer): number => widthOf(partOfLayer(name), ink);
  const penOfDots = ({ ink }: DotLayer): number => widthOf('dots', ink);
  const pens = [...lines.map(penOfLines), ...dots.map(penOfDots)];
  if (pens.length === 0) return { lines, dots };
  const map = new PassMap(width, height, Math.min(...pens));
  const counts = [...lines.map(({ paths }) => paths.length), ...dots.map((layer) => layer.dots.length)];
  const all = counts.reduce((sum, count) => sum + count, 0);
  let done = 0;
  const left = { lines: [] as PathLayer[], dots: [] as DotLayer[] };
  for (const layer of lines) {
    const pen = penOfLines(layer);
    const paths: LinePath[] = [];
    for (const path of layer.paths) {
      if (++done % 16 === 0) yield done / all;
      if (!path.isDash && pathLength(path) < shortest) continue;
      for (const piece of freePieces(path, pen, Math.max(shortest, SHORTEST * pen), map, passes)) {
        map.addPath(piece, pen);
        paths.push(piece);
      }
    }
    left.lines.push({ ...layer, paths });
  }
  for (const layer of dots) {
    const pen = penOfDots(layer);
    const kept: Dot[] = [];
    for (const dot of layer.dots) {
      if (++done % 16 === 0) yield done / all;
      const radius = Math.max(dot.radius, pen / 2);
      if (map.fullShare(dot.x, dot.y, radius, passes) > DOT_SHARE) continue;
      map.addDisc(dot.x, dot.y, radius);
      kept.push(dot);
    }
    left.dots.push({ ...layer, dots: kept });
  }
  return left;
}

/** The pieces of a path that may be drawn. shortest: of a piece that is cut off, pixels. */
function freePieces(path: LinePath, pen: number, shortest: number, map: PassMap, passes: number): LinePath[] {
  const places: number[] = [];
  const shares: number[] = [];
  alongPath(path, APART * pen, (x, y, dx, dy, place) => {
    places.push(place);
    shares.push(map.fullAcross(x, y, dx, dy, pen, passes));
  });
  if (!shares.some((share) => share > 0)) return [path];
  const isFull = fullPlaces(shares);
  const full = isFull.filter(Boolean).length;
  // A dash is one of many, which look alike.
  if (path.isDash) return 2 * full > places.length ? [] : [path];
  if (full === 0) return [path];
  const length = pathLength(path);
  const left = bridged(freeSpans(places, isFull, length), pen);
  const isWhole = left.length === 1 && left[0][0] === 0 && left[0][1] === length;
  if (isWhole) return [path];
  const kept = left.filter(([from, to]) => to - from >= shortest);
  return piecesOf(path, kept);
}

/** Whether a line is full at each place. shares: of its width that have all passes. */
function fullPlaces(shares: readonly number[]): boolean[] {
  const sums = [0];
  for (const share of shares) sums.push(sums[sums.length - 1] + share);
  return shares.map((share, i) => {
    const [from, to] = [Math.max(i - AROUND, 0), Math.min(i + AROUND + 1, shares.length)];
    return share > MOST_OF_WIDTH || (share > 0 && sums[to] - sums[from] > MOST_AROUND * (to - from));
  });
}

/** The spans between full places. */
function freeSpans(places: readonly number[], isFull: readonly boolean[], length: number): Span[] {
  const spans: Span[] = [];
  const borders = places.map((place, i) => (i === 0 ? 0 : 0.5 * (places[i - 1] + place)));
  let start = -1;
  for (const [i, border] of [...borders, length].entries()) {
    const isEnd = i === places.length || isFull[i];
    if (isEnd && start >= 0) spans.push([start, border]);
    if (isEnd) start = -1;
    else if (start < 0) start = border;
  }
  return spans;
}

/** Spans, with the short gaps between long ones closed. */
function bridged(spans: readonly Span[], pen: number): Span[] {
  const joined: Span[] = [];
  const isLong = ([from, to]: Span): boolean => to - from >= LONG * pen;
  for (const [i, span] of spans.entries()) {
    const last = joined[joined.length - 1];
    const isBridged = i > 0 && span[0] - last[1] <= BRIDGED * pen && isLong(spans[i - 1]) && isLong(span);
    if (isBridged) joined[joined.length - 1] = [last[0], span[1]];
    else joined.push(span);
  }
  return joined;
}
