import type { StrokeMeasure } from './measureStroke.js';

/** The strokes of one direction. */
export interface HandLayer {
  strokes: StrokeMeasure[];
  /** The direction in which most of them were drawn, in radians, clockwise from x. */
  angle: number;
}

/** Bins of the histogram of directions over half a turn. */
const BINS = 180;
/** Blur of that histogram, in degrees. */
const BLUR = 6;
/** Least angle between two layers, in degrees. */
const LEAST_APART = 20;
/** Least angle between two layers, as a multiple of the spread of their directions. */
const TIMES_SPREAD = 4;
/** Least ink of a layer, as a share of that of the largest. */
const LEAST_SHARE = 0.1;
/** Least share of the strokes of a second layer that cross a stroke of the first. */
const CROSSING_SHARE = 0.3;
/** Strokes of a layer that are tested for crossings. */
const TRIED = 80;

/**
 * Separates strokes into crossing layers of one direction each. The first is the layer in the lightest swatch; of several, the one with the
 * most ink. Strokes of other directions that cross nothing, such as a swatch drawn with the sheet turned, belong to the first.
 */
export function separateLayers(strokes: readonly StrokeMeasure[]): HandLayer[] {
  const peaks = peaksOf(strokes);
  const groups = peaks.map((): StrokeMeasure[] => []);
  for (const stroke of strokes) groups[nearest(peaks, degreesOf(stroke))].push(stroke);
  const first = firstOf(groups);
  const layers = [layerOf(groups[first])];
  for (const [index, group] of groups.entries()) {
    if (index === first) continue;
    const layer = layerOf(group);
    if (isApart(layers[0], layer) && crosses(group, groups[first])) layers.push(layer);
    else layers[0].strokes.push(...group);
  }
  return layers;
}

/** The angle from one direction to another regardless of forward and back, −90 to 90 degrees. */
export function betweenDegrees(from: number, to: number): number {
  const turn = ((((to - from) * 180) / Math.PI) % 180) + 360;
  return ((turn + 90) % 180) - 90;
}

const degreesOf = ({ angle }: StrokeMeasure): number => (((angle * 180) / Math.PI) % 180) + (angle < 0 ? 180 : 0);

const apart = (a: number, b: number): number => Math.abs(((a - b + 270) % 180) - 90);

/** The most frequent directions of strokes, in degrees, weighted by ink, the largest first. */
function peaksOf(strokes: readonly StrokeMeasure[]): number[] {
  const ink = new Float64Array(BINS);
  for (const stroke of strokes) ink[Math.floor(degreesOf(stroke)) % BINS] += stroke.length;
  const density = new Float64Array(BINS);
  for (let bin = 0; bin < BINS; bin++) {
    for (let off = -3 * BLUR; off <= 3 * BLUR; off++) {
      density[(bin + off + BINS) % BINS] += ink[bin] * Math.exp((-off * off) / (2 * BLUR * BLUR));
    }
  }
  const order = Array.from(density.keys()).sort((a, b) => density[b] - density[a] || a - b);
  const peaks = [order[0]];
  for (const bin of order.slice(1)) {
    if (density[bin] < LEAST_SHARE * density[peaks[0]]) break;
    const isPeak = density[bin] >= density[(bin + 1) % BINS] && density[bin] >= density[(bin + BINS - 1) % BINS];
    if (isPeak && peaks.every((peak) => apart(peak, bin) >= LEAST_APART)) peaks.push(bin);
  }
  return peaks;
}

function nearest(peaks: readonly number[], degrees: number): number {
  let best = 0;
  for (let i = 1; i < peaks.length; i++) if (apart(peaks[i], degrees) < apart(peaks[best], degrees)) best = i;
  return best;
}

/** The group with the most ink in the lightest swatch that was drawn. */
function firstOf(groups: readonly StrokeMeasure[][]): number {
  const lightest = (['light', 'middle', 'dark'] as const).find((tone) =>
    groups.some((group) => group.some(({ swatch }) => swatch === tone)),
  );
  const inks = groups.map((group) =>
    group.reduce((sum, { swatch, length }) => sum + (swatch === lightest ? length : 0), 0),
  );
  return inks.indexOf(Math.max(...inks));
}

function layerOf(strokes: StrokeMeasure[]): HandLayer {
  let [cosine, sine] = [0, 0];
  for (const { angle, length } of strokes) {
    cosine += length * Math.cos(2 * angle);
    sine += length * Math.sin(2 * angle);
  }
  const axis = 0.5 * Math.atan2(sine, cosine);
  const forward = strokes.reduce((sum, { angle, length }) => sum + length * Math.sign(Math.cos(angle - axis)), 0);
  return { strokes, angle: forward < 0 ? axis + Math.PI : axis };
}

function isApart(first: HandLayer, second: HandLayer): boolean {
  if (first.strokes.length < 2 || second.strokes.length < 2) return false;
  const between = Math.abs(betweenDegrees(first.angle, second.angle));
  const squares = (layer: HandLayer): number =>
    layer.strokes.reduce((sum, { angle }) => sum + betweenDegrees(layer.angle, angle) ** 2, 0);
  const spread = Math.sqrt((squares(first) + squares(second)) / (first.strokes.length + second.strokes.length));
  return between >= LEAST_APART && between >= TIMES_SPREAD * spread;
}

/** Whether enough strokes of the second group cross one of the first. */
function crosses(second: readonly StrokeMeasure[], first: readonly StrokeMeasure[]): boolean {
  const some = (strokes: readonly StrokeMeasure[]): readonly StrokeMeasure[] => {
    const step = Math.ceil(strokes.length / TRIED);
    return strokes.filter((_, i) => i % step === 0);
  };
  const tried = some(second);
  const beside = some(first);
  const crossing = tried.filter((stroke) => beside.some((other) => chordsCross(stroke, other)));
  return crossing.length >= CROSSING_SHARE * tried.length;
}

function chordsCross(a: StrokeMeasure, b: StrokeMeasure): boolean {
  const cross = a.forward[0] * b.forward[1] - a.forward[1] * b.forward[0];
  if (cross === 0) return false;
  const dx = b.middle[0] - a.middle[0];
  const dy = b.middle[1] - a.middle[1];
  return (
    Math.abs(dx * b.forward[1] - dy * b.forward[0]) <= Math.abs(cross) &&
    Math.abs(dx * a.forward[1] - dy * a.forward[0]) <= Math.abs(cross)
  );
}
