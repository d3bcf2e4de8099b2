import { HAND_STROKE_CONSTANTS, HAND_TEXTURE } from './handConstants.js';
import { drawnAside } from './strokeBundles.js';

const { PLACES } = HAND_TEXTURE;
const { BUNDLED_ROWS, WIDENED_ENDS } = HAND_STROKE_CONSTANTS;

/** How strokes in rows draw a tone. */
export interface DrawnTone {
  /** The share of the strokes that are there. */
  share: number;
  /** What is added to their half widths, in distances between rows: 0 until all are there. The ends of a stroke stay pointed. */
  widening: number;
}

/** Cells across a row in which the ink of strokes is counted, per distance between rows, and how far they reach to each side. */
const FINENESS = 64;
const REACH = 4;
const CELLS = 2 * REACH * FINENESS;

/** Places between two rows at which a tone is computed. */
const PHASES = 16;

/** Widths, and shares of strokes, whose tones are computed; others lie between them. */
const WIDENINGS = 12;
const SHARES = 12;

/**
 * How to draw `PLACES` tones from 0 to 1: strokes become more until all are there, and then wider. The tone is that of strokes which are
 * there independently of each other, one in each cell of a row, over rows that a point may lie on.
 *
 * @param strokes offset and half width at steady steps along each stroke, in distances between rows
 * @param filled the mean share of a cell that its stroke fills
 * @param widest the greatest widening
 * @param youngRows the number of shares of the young rows, from 0 to 1, for which tones are computed
 * @param bundled the share of their distance by which rows are drawn together to bundles
 * @param lanes how far the two lanes of each row lie to its sides, 0 for rows of one lane, and the share of the length of a row where both
 *   have strokes
 */
export function drawnTones(
  strokes: Float32Array,
  filled: number,
  widest: number,
  youngRows: number,
  bundled: number,
  lanes: { offset: number; both: number },
): readonly (readonly DrawnTone[])[] {
  const widenings = Array.from({ length: WIDENINGS }, (_, i) => (widest * i) / (WIDENINGS - 1));
  const covers = widenings.map((widening) => coverAcross(strokes, filled, widening));
  const shares = Array.from({ length: SHARES }, (_, i) => i / SHARES);
  // First of few strokes, then of all that there are, ever wider.
  const drawn = [
    ...shares.map((share) => ({ share, widening: 0 })),
    ...widenings.map((widening) => ({ share: 1, widening })),
  ];
  return Array.from({ length: youngRows }, (_, row) => {
    const near = rowsNear(row / (youngRows - 1), bundled, lanes.offset);
    const joint = lanes.both / filled ** 2;
    const tones = drawn.map(({ share }, i) => toneOf(covers[Math.max(0, i - SHARES)], share, near, joint));
    return Array.from({ length: PLACES }, (_, place) => drawnBetween(drawn, tones, place / (PLACES - 1)));
  });
}

/** How a tone is drawn, between those that are known, which grow. */
function drawnBetween(drawn: readonly DrawnTone[], tones: readonly number[], tone: number): DrawnTone {
  const next = tones.findIndex((value) => value > tone);
  if (next < 1) return drawn[next < 0 ? drawn.length - 1 : 0];
  const part = (tone - tones[next - 1]) / (tones[next] - tones[next - 1]);
  const [from, to] = [drawn[next - 1], drawn[next]];
  return {
    share: from.share + part * (to.share - from.share),
    widening: from.widening + part * (to.widening - from.widening),
  };
}

/** How much of the length of a row its strokes cover at a distance to its side. */
interface Cover {
  /** The share, by the distance in cells from `-REACH` on. */
  shares: Float32Array;
  /** The cells of which the share is above 0: the first, and the one after the last. */
  from: number;
  to: number;
}

function coverAcross(strokes: Float32Array, filled: number, widening: number): Cover {
  const steps = new Int32Array(CELLS + 1);
  const added = Float64Array.from({ length: PLACES }, (_, i) => {
    const place = i / (PLACES - 1);
    return widening * Math.min(1, WIDENED_ENDS * Math.min(place, 1 - place));
  });
  for (let i = 0; i < strokes.length; i += 2) {
    const half = strokes[i + 1] + added[(i >> 1) % PLACES];
    steps[cellOf(strokes[i] - half)]++;
    steps[cellOf(strokes[i] + half)]--;
  }
  const shares = new Float32Array(CELLS);
  let from = 0;
  while (from < CELLS && steps[from] === 0) from++;
  let to = CELLS;
  while (to > from && steps[to] === 0) to--;
  let count = 0;
  for (let cell = from; cell < to; cell++) {
    count += steps[cell];
    shares[cell] = (filled * count) / (strokes.length / 2);
  }
  return { shares, from, to };
}

const cellOf = (distance: number): number => {
  const cell = Math.floor((distance + REACH) * FINENESS + 0.5);
  return cell < 0 ? 0 : cell > CELLS ? CELLS : cell;
};

/** The rows near a place between two of them. */
interface NearRows {
  /** The cells of a cover in which the place lies, of the first lane of each row and of the second; −1 where it lies in none. */
  first: Int32Array;
  second: Int32Array;
  /** The share of the strokes of each row that is there if all of its kind are. */
  shares: Float64Array;
}

/** The rows near each place, old ones 1 + young apart, with young ones between them of whose strokes that share is there. */
function rowsNear(young: number, bundled: number, laneOffset: number): readonly NearRows[] {
  const apart = 1 + young;
  const most = Math.ceil((2 * REACH) / apart) + 1;
  const phases = (bundled > 0 ? BUNDLED_ROWS : 1) * PHASES;
  const asides = Array.from({ length: 2 * BUNDLED_ROWS }, (_, half) => drawnAside(half, young, bundled));
  return Array.from({ length: phases }, (_, phase) => {
    const place = (phase + 0.5) / PHASES;
    const start = 2 * (Math.floor(place) - most);
    const [first, second, shares]: [number[], number[], number[]] = [[], [], []];
    for (let half = start; half <= start + 4 * most + 2; half++) {
      const share = half % 2 === 0 ? 1 : young;
      const away = (place - 0.5 * half) * apart - asides[(half + most * asides.length) % asides.length];
      const [cell, beside] = [cellAt(away + laneOffset), laneOffset > 0 ? cellAt(away - laneOffset) : -1];
      if (share === 0 || (cell < 0 && beside < 0)) continue;
      first.push(cell);
      second.push(beside);
      shares.push(share);
    }
    return { first: Int32Array.from(first), second: Int32Array.from(second), shares: Float64Array.from(shares) };
  });
}

/** The cell in which a distance lies; −1 for none. */
function cellAt(distance: number): number {
  const cell = Math.floor((distance + REACH) * FINENESS);
  return cell < CELLS ? Math.max(cell, -1) : -1;
}

/**
 * The mean tone of rows in which a share of the strokes is there.
 *
 * @param joint how often both lanes of a row have strokes at a place, as a multiple of how often they would by chance
 */
function toneOf({ shares, from, to }: Cover, share: number, near: readonly NearRows[], joint: number): number {
  if (share === 0) return 0;
  let blank = 0;
  for (const { first, second, shares: there } of near) {
    let left = 1;
    for (let i = 0; i < first.length; i++) {
      const ofFirst = first[i] >= from && first[i] < to ? share * there[i] * shares[first[i]] : 0;
      const ofSecond = second[i] >= from && second[i] < to ? share * there[i] * shares[second[i]] : 0;
      left *= 1 - ofFirst - ofSecond + joint * ofFirst * ofSecond;
    }
    blank += left;
  }
  return 1 - blank / near.length;
}
