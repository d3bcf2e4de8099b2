import type { SwatchTone } from './Hand.js';
import { arcAt, type StrokeMeasure } from './measureStroke.js';
import type { HandLayer } from './separateLayers.js';

/** Scan lines across a swatch along which neighbours are searched. */
const SCANS = 41;

/** Largest number of strokes that are measured: of more, those in the middle of the swatch. */
const MOST = 1500;

/** Scan lines that meet fewer strokes than this share of the median are ignored: they lie at the border of the swatch. */
const LEAST_MET = 0.9;

/** The next stroke of a row begins beyond this share of a stroke's length, measured from middle to middle. */
const NEXT_BEYOND = 0.4;
/** It begins up to this share of the length behind or ahead of the stroke's end. */
const NEXT_WITHIN = 0.7;
/** It lies at most this share of the distance of neighbours beside the stroke. */
const NEXT_BESIDE = 0.4;
/** Strokes beside a stroke's end that are tested as the next of its row. */
const TRIED_NEXT = 64;
/** Rows are accepted if this share of the strokes has a next one. */
const ROWS_SHARE = 0.25;

/** The spacing of the strokes of one layer in one swatch. */
export interface SwatchSpacing {
  swatch: SwatchTone;
  /** The number of pairs of neighbours that were measured. */
  pairs: number;
  /** Mean distance of neighbours, in millimetres. */
  spacing: number;
  /** Its standard deviation, as a share of it. */
  spread: number;
  /** 1 − median / mean of the distances. */
  clustering: number;
  /** The share of the length beside the next stroke of the row; undefined without rows. */
  overlap: number | undefined;
}

/** A stroke in the coordinates of its layer. */
interface Span {
  from: number;
  to: number;
  stroke: StrokeMeasure;
  sign: number;
  /** The range in which it counts as the only stroke of its row. */
  rowFrom: number;
  rowTo: number;
}

/** Measures the strokes of a layer in one swatch. Undefined if no two of them lie side by side. */
export function measureSpacing({ strokes, angle }: HandLayer, swatch: SwatchTone): SwatchSpacing | undefined {
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  const spans = middleOf(
    strokes.filter((stroke) => stroke.swatch === swatch).map((stroke) => spanOf(turned(stroke, cosine, sine))),
  );
  const roughly = neighbours(spans);
  if (roughly.length === 0) return undefined;
  const overlap = followRows(spans, quantile(roughly, 0.5));
  const pairs = neighbours(spans);
  const total = pairs.reduce((sum, { weight }) => sum + weight, 0);
  const mean = pairs.reduce((sum, { distance, weight }) => sum + distance * weight, 0) / total;
  const squares = pairs.reduce((sum, { distance, weight }) => sum + weight * (distance - mean) ** 2, 0);
  const variance = ((squares / total) * pairs.length) / Math.max(1, pairs.length - 1);
  return {
    swatch,
    pairs: pairs.length,
    spacing: mean,
    spread: Math.sqrt(variance) / mean,
    clustering: Math.max(0, 1 - quantile(pairs, 0.5) / mean),
    overlap,
  };
}

function middleOf(spans: Span[]): Span[] {
  if (spans.length <= MOST) return spans;
  const sorted = spans.sort((a, b) => a.stroke.middle[1] - b.stroke.middle[1]);
  const first = Math.floor(0.5 * (spans.length - MOST));
  return sorted.slice(first, first + MOST);
}

/** The same stroke with x along the layer and y across it. */
function turned(stroke: StrokeMeasure, cosine: number, sine: number): StrokeMeasure {
  const turn = ([x, y]: readonly [number, number]): [number, number] => [x * cosine + y * sine, y * cosine - x * sine];
  return { ...stroke, middle: turn(stroke.middle), forward: turn(stroke.forward), bend: turn(stroke.bend) };
}

function spanOf(stroke: StrokeMeasure): Span {
  const [a, b] = [arcAt(stroke, 0, -1), arcAt(stroke, 0, 1)];
  const [from, to] = [Math.min(a, b), Math.max(a, b)];
  return { from, to, stroke, sign: b < a ? -1 : 1, rowFrom: from, rowTo: to };
}

/** The position of a stroke across its layer; beyond its ends it is extrapolated. */
function acrossAt({ from, to, stroke, sign }: Span, along: number): number {
  const s = Math.max(-1, Math.min(1, (2 * along - from - to) / (to - from || 1)));
  return arcAt(stroke, 1, sign * s);
}

interface Pair {
  /** The mean distance, over all lines across that meet both side by side. */
  distance: number;
  /** The number of those lines. */
  weight: number;
}

/**
 * The pairs of strokes side by side: each stroke with the one next to it for most of its length. Where that has ended, the one beyond it is
 * no neighbour.
 */
function neighbours(spans: readonly Span[]): Pair[] {
  const first = spans.reduce((least, { from }) => Math.min(least, from), Infinity);
  const last = spans.reduce((most, { to }) => Math.max(most, to), -Infinity);
  const lines: { index: number; across: number }[][] = [];
  for (let scan = 0; scan < SCANS; scan++) {
    const along = first + ((scan + 0.5) / SCANS) * (last - first);
    const met: { index: number; across: number }[] = [];
    for (const [index, span] of spans.entries()) {
      if (along >= span.rowFrom && along < span.rowTo) met.push({ index, across: acrossAt(span, along) });
    }
    if (met.length > 0) lines.push(met.sort((a, b) => a.across - b.across));
  }
  if (lines.length === 0) return [];
  const counts = lines.map(({ length }) => length).sort((a, b) => a - b);
  const least = LEAST_MET * counts[Math.floor(counts.length / 2)];
  const pairs = spans.map(() => new Map<number, Pair>());
  for (const line of lines) {
    if (line.length < least) continue;
    for (let i = 1; i < line.length; i++) {
      const beside = pairs[line[i - 1].index];
      const pair = beside.get(line[i].index) ?? { distance: 0, weight: 0 };
      pair.distance += line[i].across - line[i - 1].across;
      pair.weight++;
      beside.set(line[i].index, pair);
    }
  }
  return pairs.flatMap((beside) => {
    if (beside.size === 0) return [];
    const { distance, weight } = [...beside.values()].reduce((most, pair) => (pair.weight > most.weight ? pair : most));
    return [{ distance: distance / weight, weight }];
  });
}

function quantile(pairs: readonly Pair[], share: number): number {
  const sorted = pairs.toSorted((a, b) => a.distance - b.distance);
  let rest = share * sorted.reduce((sum, { weight }) => sum + weight, 0);
  for (const { distance, weight } of sorted) {
    rest -= weight;
    if (rest <= 0) return distance;
  }
  return sorted[sorted.length - 1].distance;
}

/**
 * Finds for each stroke the one that follows it end to end in its row. Where two overlap or leave a gap, each counts as the only stroke of
 * the row up to the middle, so that neighbours belong to other rows.
 *
 * @returns the mean overlap as a share of the mean length; undefined if the strokes do not stand in rows
 */
function followRows(spans: Span[], spacing: number): number | undefined {
  const length = spans.reduce((sum, { from, to }) => sum + to - from, 0) / spans.length;
  const byStart = spans.toSorted((a, b) => a.from - b.from);
  const links: { span: Span; next: Span; gap: number }[] = [];
  for (const span of spans) {
    let best: Span | undefined;
    let leastCost = Infinity;
    let tried = 0;
    for (let i = firstFrom(byStart, span.to - NEXT_WITHIN * length); i < byStart.length && tried < TRIED_NEXT; i++) {
      const other = byStart[i];
      if (other.from > span.to + NEXT_WITHIN * length) break;
      if (other.from + other.to - span.from - span.to < 2 * NEXT_BEYOND * length) continue;
      const along = 0.5 * (span.to + other.from);
      const beside = Math.abs(acrossAt(span, along) - acrossAt(other, along));
      if (beside > 4 * spacing) continue;
      tried++;
      // Of strokes in the same row, it is the nearest.
      const cost = beside / spacing + Math.abs(other.from - span.to) / length;
      if (beside < NEXT_BESIDE * spacing && cost < leastCost) {
        leastCost = cost;
        best = other;
      }
    }
    if (best) links.push({ span, next: best, gap: best.from - span.to });
  }
  if (links.length < Math.max(2, ROWS_SHARE * spans.length)) return undefined;
  for (const { span, next } of links) {
    const middle = 0.5 * (span.to + next.from);
    span.rowTo = middle;
    next.rowFrom = middle;
  }
  return -links.reduce((sum, { gap }) => sum + gap, 0) / links.length / length;
}

/** The index of the first span that begins at `from` or later. */
function firstFrom(byStart: readonly Span[], from: number): number {
  let [low, high] = [0, byStart.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (byStart[middle].from < from) low = middle + 1;
    else high = middle;
  }
  return low;
}
