/** The greatest number of spans of a tone curve through points: one less than its points. */
export const TONE_CURVE_SPANS = 7;

/** A point of a tone curve: the tone of the light, and the tone that is printed for it. Both are in [0, 1], where 0 is paper. */
export type ToneCurvePoint = readonly [light: number, printed: number];

/** The values of `HatchingMaterial.toneCurve`. */
export type ToneCurve = 'linear' | 'perceptual' | 'printed' | readonly ToneCurvePoint[];

/** The points of the curve `'printed'`. */
const PRINTED: readonly ToneCurvePoint[] = [
  [0, 0],
  [0.15, 0],
  [0.3, 0.06],
  [0.45, 0.22],
  [0.6, 0.44],
  [0.75, 0.65],
  [0.9, 0.8],
  [1, 0.86],
];

/** The points of a curve; undefined for curves that the shader computes. */
function pointsOf(curve: ToneCurve): readonly ToneCurvePoint[] | undefined {
  if (curve === 'printed') return PRINTED;
  return curve === 'linear' || curve === 'perceptual' ? undefined : curve;
}

/** The ends of a curve that the shader computes. */
const WHOLE: readonly [number, number] = [0, 1];
/** A cache of the ends of curves through points, which are needed in every frame. */
const endsOf = /* @__PURE__ */ new WeakMap<readonly ToneCurvePoint[], readonly [number, number]>();

/** The tones that a curve prints for light tones 0 and 1. Allocates nothing for a curve that is cached. */
export function curveEnds(curve: ToneCurve): readonly [number, number] {
  const points = pointsOf(curve);
  if (!points) return WHOLE;
  let ends = endsOf.get(points);
  if (!ends) {
    ends = [points[0][1], points[points.length - 1][1]];
    endsOf.set(points, ends);
  }
  return ends;
}

/** A tone curve as a sum of `start` and one cubic per span. Unused spans add nothing. */
export interface FittedToneCurve {
  start: number;
  /** The start and 1 / width of each span. */
  spans: Float32Array;
  /** The coefficients of t, t² and t³ of each span, where t runs from 0 to 1 over the span. */
  cubics: Float32Array;
}

/**
 * Fits a curve through the points: a cubic spline with the slopes of Fritsch and Butland, 1984, which never leaves the range
 * between two neighbouring points. Before the first and after the last point it is constant. Two points give a straight line.
 *
 * @param points 2 to 8, from light to dark
 * @throws Error if there are fewer or more, if one is not a pair of numbers in [0, 1], or if their lights do not rise
 */
export function fitToneCurve(points: readonly ToneCurvePoint[]): FittedToneCurve {
  checkPoints(points);
  const widths = differences(points.map(([light]) => light));
  const rises = differences(points.map(([, printed]) => printed));
  const secants = rises.map((rise, i) => rise / widths[i]);
  const slopes = points.map((_, i) => slopeBetween(secants[i - 1], secants[i], widths[i - 1], widths[i]));

  const spans = new Float32Array(2 * TONE_CURVE_SPANS);
  const cubics = new Float32Array(3 * TONE_CURVE_SPANS);
  widths.forEach((width, i) => {
    const begin = width * slopes[i];
    const end = width * slopes[i + 1];
    spans.set([points[i][0], 1 / width], 2 * i);
    cubics.set([begin, 3 * rises[i] - 2 * begin - end, begin + end - 2 * rises[i]], 3 * i);
  });
  return { start: points[0][1], spans, cubics };
}

/**
 * The fitted curve for the shader; undefined for a curve that the shader computes.
 *
 * @throws Error if `curve` is not a tone curve
 */
export function fittedCurve(curve: ToneCurve): FittedToneCurve | undefined {
  const points = pointsOf(curve);
  return points && fitToneCurve(points);
}

/** The slope at a point between two spans: their harmonic mean, with which the curve overshoots in neither; 0 at a turning point. */
function slopeBetween(before = Number.NaN, after = Number.NaN, widthBefore = 0, widthAfter = 0): number {
  if (Number.isNaN(before)) return after;
  if (Number.isNaN(after)) return before;
  if (before * after <= 0) return 0;
  const [a, b] = [2 * widthAfter + widthBefore, widthAfter + 2 * widthBefore];
  return (a + b) / (a / before + b / after);
}

const differences = (values: readonly number[]): number[] => values.slice(1).map((value, i) => value - values[i]);

function checkPoints(points: readonly ToneCurvePoint[]): void {
  const fail = (what: string): never => {
    throw new Error(`HatchingMaterial.toneCurve: ${what}; give 2 to ${TONE_CURVE_SPANS + 1} pairs [light, printed].`);
  };
  if (!Array.isArray(points))
    fail(`${JSON.stringify(points)} is neither 'linear' nor 'perceptual' nor 'printed' nor a list of points`);
  if (points.length < 2 || points.length > TONE_CURVE_SPANS + 1) fail(`${points.length} points are not a curve`);
  points.forEach((point, i) => {
    const isPair = Array.isArray(point) && point.length === 2 && point.every((x) => x >= 0 && x <= 1);
    if (!isPair) fail(`point ${i}, ${JSON.stringify(point)}, is not a pair of tones in [0, 1]`);
    if (i > 0 && !(point[0] > points[i - 1][0])) fail(`point ${i} is not at a darker light than the one before it`);
  });
}
