import type { Ink } from './findInk.js';
import type { Chain } from './resolveJunctions.js';

/** A stroke in pixels: its centre line and its width at every point. */
export interface TracedStroke extends Path {
  widths: Float64Array;
}

/** Pixels between the samples along a stroke. */
const SPACING = 1;
/** Pixels between the samples across a stroke. */
const STEP = 0.5;
/** Smoothing of the line of pixels before it is measured, and of the measured line and widths after, in pixels. */
const RAW_SMOOTHING = 2;
const FINE_SMOOTHING = 1.2;
/** A stroke ends where its ink falls below this share. */
const HALF = 0.5;
/** The same for pointed ends: a point thinner than a pixel has less than half, but continues for `POINT_PIXELS` or more. */
const POINT_SHARE = 0.2;
const POINT_PIXELS = 2;
/** Smaller shares count as no ink. */
const NOTHING = 0.04;
/** Largest width of a stroke, as a multiple of the width in four fifths of its length. */
const WIDEST_SWELL = 1.5;
/** A stroke whose ink has at least this share of the depth of ink is considered blurred, not paler. */
const BLURRED = 0.7;

/**
 * Measures a stroke across its line: its width is the amount of ink there, which neither blur nor pixels change. At crossings, the width is
 * interpolated.
 *
 * @returns undefined for marks no longer than wide: specks, dots and blots
 */
export function measureChain(ink: Ink, chain: Chain): TracedStroke | undefined {
  if (chain.radii.length < 2) return undefined;
  const line = withEnds(ink, chain);
  const { xs, ys } = resample(line, SPACING);
  const count = xs.length;
  const smoothX = smooth(xs, RAW_SMOOTHING);
  const smoothY = smooth(ys, RAW_SMOOTHING);
  const radii = radiiAlong(chain, count);
  const full = depthAlong(ink, smoothX, smoothY);
  const isHidden = hiddenSamples(line, chain, count);
  const widths = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    const before = Math.max(0, i - 3);
    const after = Math.min(count - 1, i + 3);
    const alongX = smoothX[after] - smoothX[before];
    const alongY = smoothY[after] - smoothY[before];
    const length = Math.hypot(alongX, alongY) || 1;
    const [normalX, normalY] = [-alongY / length, alongX / length];
    const section = isHidden[i]
      ? undefined
      : crossSection(ink, full, smoothX[i], smoothY[i], normalX, normalY, radii[i]);
    widths[i] = section ? section.width : Number.NaN;
    xs[i] = smoothX[i] + (section ? section.offset * normalX : 0);
    ys[i] = smoothY[i] + (section ? section.offset * normalY : 0);
  }
  if (!bridge([xs, ys, widths], withoutCrossings(widths))) return undefined;
  return withoutCaps({ xs: smooth(xs, FINE_SMOOTHING), ys: smooth(ys, FINE_SMOOTHING), widths });
}

/** The share of ink at a place, bilinear; 1 in the middle of a stroke of the depth `full`. */
function inkAt({ width, height, depths }: Ink, full: number, x: number, y: number): number {
  const column = Math.min(width - 1.001, Math.max(0, x));
  const row = Math.min(height - 1.001, Math.max(0, y));
  const left = Math.floor(column);
  const top = Math.floor(row);
  const at = top * width + left;
  const across = column - left;
  const upper = depths[at] + across * (depths[at + 1] - depths[at]);
  const lower = depths[at + width] + across * (depths[at + width + 1] - depths[at + width]);
  return (upper + (lower - upper) * (row - top)) / full;
}

/** Thinning shortens lines and bends their ends into corners: both ends are cut back and then extended to the end of the ink. */
function withEnds(ink: Ink, { points, radii, isClosed }: Chain): number[] {
  if (isClosed) return [...points, points[0], points[1]];
  const head = endOf(ink, points, radii);
  const reversed = reversedPoints(points);
  const tail = endOf(ink, reversed, radii.slice().reverse());
  const from = head.dropped;
  const to = radii.length - tail.dropped;
  return [...head.tip, ...points.slice(2 * from, 2 * to), ...reversedPoints(tail.tip)];
}

function endOf(ink: Ink, points: readonly number[], radii: readonly number[]): { dropped: number; tip: number[] } {
  const count = radii.length;
  const radius = Math.max(...radii.slice(0, Math.max(2, Math.ceil(count / 8))).slice(0, 8));
  const dropped = Math.min(Math.floor(radius), Math.floor((count - 1) / 4));
  const behind = Math.min(count - 1, dropped + Math.ceil(3 * radius) + 3);
  const [x, y] = [points[2 * dropped], points[2 * dropped + 1]];
  let alongX = x - points[2 * behind];
  let alongY = y - points[2 * behind + 1];
  const length = Math.hypot(alongX, alongY);
  if (length === 0) return { dropped, tip: [] };
  alongX /= length;
  alongY /= length;
  const inkEnd = (share: number, most: number): number => {
    let distance = 0;
    while (distance < most && inkAt(ink, ink.fullDepth, x + distance * alongX, y + distance * alongY) > share) {
      distance += 0.25;
    }
    return distance;
  };
  const half = inkEnd(HALF, 3 * radius + 4);
  const point = inkEnd(POINT_SHARE, 3 * radius + 10);
  const distance = point - half > POINT_PIXELS ? point : half;
  return { dropped, tip: distance > 0 ? [x + distance * alongX, y + distance * alongY] : [] };
}

function reversedPoints(points: readonly number[]): number[] {
  const reversed: number[] = [];
  for (let i = points.length - 2; i >= 0; i -= 2) reversed.push(points[i], points[i + 1]);
  return reversed;
}

/** The distance to paper along the samples of a stroke. It only bounds the length of cross sections. */
function radiiAlong({ radii }: Chain, count: number): Float64Array {
  const result = new Float64Array(count);
  const typical = Float64Array.from(radii).sort()[Math.floor(0.75 * (radii.length - 1))];
  for (let i = 0; i < count; i++) {
    const at = Math.round((i / Math.max(1, count - 1)) * (radii.length - 1));
    result[i] = Math.min(Math.max(radii[at], 0.5 * typical), 2 * typical);
  }
  return result;
}

/** The depth of the ink of one stroke: that of the picture, or its own if it is paler than blur would make it. */
function depthAlong(ink: Ink, xs: Float64Array, ys: Float64Array): number {
  const own = xs.map((x, i) => inkAt(ink, ink.fullDepth, x, ys[i])).sort()[Math.floor(0.6 * xs.length)];
  return own > BLURRED ? ink.fullDepth : Math.max(0.3, own) * ink.fullDepth;
}

/** The amount of ink across a stroke, and its middle; undefined where the ink does not end, as in a crossing. */
function crossSection(
  ink: Ink,
  full: number,
  x: number,
  y: number,
  normalX: number,
  normalY: number,
  radius: number,
): { width: number; offset: number } | undefined {
  const reach = 1.5 * radius + 3;
  let sum = 0;
  let moment = 0;
  for (const side of [-1, 1]) {
    let least = Number.POSITIVE_INFINITY;
    let at = 0.5 * STEP;
    for (; at < reach; at += STEP) {
      const share = inkAt(ink, full, x + side * at * normalX, y + side * at * normalY);
      // Ink that rises again belongs to the stroke beside it.
      if (share < NOTHING || (least < HALF && share > least + 0.06)) break;
      least = Math.min(least, share);
      sum += share;
      moment += side * at * share;
    }
    if (least > HALF && at >= reach) return undefined;
  }
  if (sum === 0) return { width: 0, offset: 0 };
  const most = 0.5 * radius + 0.5;
  return { width: sum * STEP, offset: Math.min(most, Math.max(-most, moment / sum)) };
}

/** The samples covered by other strokes: gaps between pixels of the line, and its ends in other strokes. */
function hiddenSamples(line: readonly number[], { startRadius, endRadius }: Chain, count: number): Uint8Array {
  const isHidden = new Uint8Array(count);
  const gaps: [from: number, to: number][] = [];
  let length = 0;
  for (let i = 2; i < line.length; i += 2) {
    const step = Math.hypot(line[i] - line[i - 2], line[i + 1] - line[i - 1]);
    // Extensions to the ends of the ink are long steps too, but no gaps.
    if (step > 2 && i > 2 && i < line.length - 2) gaps.push([length, length + step]);
    length += step;
  }
  if (startRadius > 0) gaps.push([0, 2 * startRadius]);
  if (endRadius > 0) gaps.push([length - 2 * endRadius, length]);
  const spacing = length / Math.max(1, count - 1);
  for (const [from, to] of gaps) {
    const first = Math.max(0, Math.floor(from / spacing));
    isHidden.fill(1, first, Math.min(count, Math.ceil(to / spacing) + 1));
  }
  return isHidden;
}

/** The widths without those that are much larger than the others, where another stroke must lie. */
function withoutCrossings(widths: Float64Array): Float64Array {
  const known = widths.filter((width) => !Number.isNaN(width)).sort();
  const most = WIDEST_SWELL * known[Math.floor(0.8 * (known.length - 1))];
  return widths.map((width) => (width > most ? Number.NaN : width));
}

/** Interpolates places and widths linearly where the width is unknown. False if none is known. */
function bridge(
  lists: readonly [xs: Float64Array, ys: Float64Array, widths: Float64Array],
  widths: Float64Array,
): boolean {
  const known: number[] = [];
  for (let i = 0; i < widths.length; i++) if (!Number.isNaN(widths[i])) known.push(i);
  if (known.length === 0) return false;
  for (let k = 0; k < known.length - 1; k++) {
    const [a, b] = [known[k], known[k + 1]];
    for (const values of lists) {
      for (let i = a + 1; i < b; i++) values[i] = values[a] + ((values[b] - values[a]) * (i - a)) / (b - a);
    }
  }
  // Where a stroke ends in another one, its line is known, but not its width.
  const [first, last] = [known[0], known[known.length - 1]];
  lists[2].fill(widths[first], 0, first);
  lists[2].fill(widths[last], last);
  return true;
}

/** Cuts blunt ends back by half their width, to the position of a round pen. Pointed ends stay. */
function withoutCaps(stroke: TracedStroke): TracedStroke | undefined {
  const { xs, ys, widths } = stroke;
  const count = xs.length;
  const lengths = new Float64Array(count);
  for (let i = 1; i < count; i++) lengths[i] = lengths[i - 1] + Math.hypot(xs[i] - xs[i - 1], ys[i] - ys[i - 1]);
  const total = lengths[count - 1];
  const typical = widths.slice().sort()[Math.floor(0.75 * (count - 1))];
  if (total < 1.6 * typical || total < 4) return undefined;
  const start = capOf(lengths, widths, typical);
  const end = capOf(
    lengths.map((_, i) => total - lengths[count - 1 - i]),
    widths.slice().reverse(),
    typical,
  );
  widths.fill(start.width, 0, start.reaches);
  widths.fill(end.width, count - end.reaches);
  const smoothed = smooth(widths, FINE_SMOOTHING).map((width) => Math.max(0, width));
  const along = Array.from({ length: count }, (_, i) => {
    return start.length + ((total - start.length - end.length) * i) / (count - 1);
  });
  const at = (values: Float64Array): Float64Array =>
    Float64Array.from(along, (length) => valueAt(lengths, values, length));
  return { xs: at(xs), ys: at(ys), widths: at(smoothed) };
}

/** The cap at the start of a stroke. */
interface Cap {
  /** Its length: half its width, or 0 for a point. */
  length: number;
  /** The width of the stroke behind it. */
  width: number;
  /** The samples whose width is that of the cap. */
  reaches: number;
}

/** Finds where the stroke is half as wide as the distance to its end: in a round or straight end, but not in a point. */
function capOf(lengths: Float64Array, widths: Float64Array, typical: number): Cap {
  const most = Math.min(0.25 * lengths[lengths.length - 1], typical);
  let length = 0;
  let i = 1;
  for (; lengths[i] < most; i++) {
    const excess = 0.5 * widths[i] - lengths[i];
    const before = 0.5 * widths[i - 1] - lengths[i - 1];
    if (excess >= 0) length = lengths[i];
    else if (before >= 0) length = lengths[i - 1] + ((lengths[i] - lengths[i - 1]) * before) / (before - excess || 1);
  }
  // The slope of a point is less than that of a cap, but pixels may hide its first ones.
  if (length < Math.max(1, 0.2 * typical)) return { length: 0, width: widths[0], reaches: 0 };
  let reaches = 0;
  while (reaches < widths.length - 1 && lengths[reaches] < length + 1) reaches++;
  return { length, width: widths[reaches], reaches };
}

function valueAt(lengths: Float64Array, values: Float64Array, length: number): number {
  const last = lengths.length - 1;
  let i = Math.min(last - 1, Math.max(0, Math.floor((length / lengths[last]) * last)));
  while (i > 0 && lengths[i] > length) i--;
  while (i < last - 1 && lengths[i + 1] < length) i++;
  const share = (length - lengths[i]) / (lengths[i + 1] - lengths[i] || 1);
  return values[i] + share * (values[i + 1] - values[i]);
}

/** A line of evenly spaced points. */
interface Path {
  xs: Float64Array;
  ys: Float64Array;
}

/** Points at even distances of about `spacing` along a line x0, y0, x1, y1, …, its ends among them; at least two. */
export function resample(points: ArrayLike<number>, spacing: number): Path {
  const count = points.length / 2;
  const lengths = new Float64Array(count);
  for (let i = 1; i < count; i++) {
    lengths[i] = lengths[i - 1] + Math.hypot(points[2 * i] - points[2 * i - 2], points[2 * i + 1] - points[2 * i - 1]);
  }
  const total = lengths[count - 1];
  const steps = Math.max(1, Math.round(total / spacing));
  const path: Path = { xs: new Float64Array(steps + 1), ys: new Float64Array(steps + 1) };
  let segment = 1;
  for (let i = 0; i <= steps; i++) {
    const wanted = (total * i) / steps;
    while (segment < count - 1 && lengths[segment] < wanted) segment++;
    const start = segment - 1;
    const share = count > 1 ? (wanted - lengths[start]) / (lengths[segment] - lengths[start] || 1) : 0;
    const end = count > 1 ? segment : start;
    path.xs[i] = points[2 * start] + share * (points[2 * end] - points[2 * start]);
    path.ys[i] = points[2 * start + 1] + share * (points[2 * end + 1] - points[2 * start + 1]);
  }
  return path;
}

/** Smooths values by a Gaussian of `deviation` samples, with point reflection at the ends, which stay fixed. */
function smooth(values: Float64Array, deviation: number): Float64Array {
  const reach = Math.min(values.length - 1, Math.ceil(3 * deviation));
  const weights = Array.from({ length: reach + 1 }, (_, i) => Math.exp((-0.5 * i * i) / (deviation * deviation)));
  const last = values.length - 1;
  const at = (i: number): number => {
    if (i < 0) return 2 * values[0] - values[-i];
    return i > last ? 2 * values[last] - values[2 * last - i] : values[i];
  };
  return values.map((value, i) => {
    let sum = value;
    let weight = 1;
    for (let step = 1; step <= reach; step++) {
      sum += weights[step] * (at(i - step) + at(i + step));
      weight += 2 * weights[step];
    }
    return sum / weight;
  });
}
