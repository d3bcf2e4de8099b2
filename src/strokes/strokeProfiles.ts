import { runToEnd } from '../mesh/phases.js';
import type { Hand, HandNumbers, SwatchTone } from './hand/Hand.js';
import { HAND_STROKE_CONSTANTS, HAND_TEXTURE, MOST_REACH } from './handConstants.js';
import { type PreparedHand, prepareHand } from './prepareHand.js';
import { PROFILE_SAMPLES } from './Stroke.js';
import { spreadOfBundles } from './strokeBundles.js';
import { type DrawnTone, drawnTones } from './strokeTones.js';

const { PLACES, HAND_ROWS, TONE_ROWS } = HAND_TEXTURE;

/** The largest number of strokes of a hand that are drawn in rows. */
export const MOST_PROFILES = HAND_ROWS - TONE_ROWS;

/** Distance between rows, as a share of that of neighbours in the middle swatch: rows lie as close as in a dark swatch. */
const ROW_SPACING = 0.6;

/** The largest share of ink of a family whose strokes are all there, as if they did not overlap. */
const MOST_INK = 0.65;

/** The part of the arc of strokes that stays, since the form bends them already. */
const KEPT_ARC = 0.5;

/** How far a stroke strays from its row by the spread of distances, as a share of it, and at most, in distances between rows. */
const STRAY = 0.5;
const MOST_STRAY = 0.3;

/** The clustering that uneven distances have without bundles, as a share of their spread. */
const CLUSTERING_OF_SPREAD = 0.3;

/** The greatest share of their distance by which rows are drawn together to bundles. */
const MOST_BUNDLED = 0.7;

/** The greatest distance of a centre line from its row, in distances between rows. */
const MOST_OFFSET = 0.7;

/** The greatest half width of a stroke, and what is added to it in the darks at most, in distances between rows. */
const MOST_HALF_WIDTH = 1.25;
const MOST_WIDENING = 2;

/** The spread of lengths that cells of two sizes bring with them. */
const SPREAD_OF_CELLS = 0.15;

/** The smallest length of a stroke, as a share of the longest in a cell of its size. */
const SHORTEST = 0.2;

/** A stroke is never longer than its cell; this gap between two of a row keeps them apart. */
const LEAST_GAP = 0.04;

/** A hand whose strokes overlap by less than this share of their length has them end to end: tracing does not tell it from that. */
const LEAST_OVERLAP = 0.04;

/** The distance of the two lanes of a row whose strokes overlap, in mean widths of strokes, and at most, in distances between rows. */
const LANE_WIDTHS = 1.6;
const MOST_LANE_DISTANCE = 0.45;

/**
 * How far the cells of the second lane are shifted, of the step from a stroke to the next one of its row: more than a step between strokes
 * of one cell, and less than one between strokes of two.
 */
const LANE_STEP = 4 / 3;

/** The mean share of their length that strokes have, of which some give way to others twice as long. */
const WHOLE = 1 - 0.5 * HAND_STROKE_CONSTANTS.PAIR_TURN;

/** The order of swatches: strokes of light tones come first. */
const SWATCHES: readonly SwatchTone[] = ['light', 'middle', 'dark'];

/** Shares of the golden ratio spread values evenly over strokes; two different ones are independent. */
const EVEN = [0.6180339887498949, 0.7548776662466927] as const;

/** The strokes of a hand as it draws them in rows of a model. Lengths are in distances between rows unless they say otherwise. */
export interface StrokeProfiles {
  /** The number of strokes, from those of the light swatch to those of the dark one. */
  count: number;
  /** Offset across the row and half of the width of each stroke at `PLACES` places along it. */
  strokes: Float32Array;
  /** How the tones from 0 to 1 are drawn, for each share of the young rows; see {@link drawnTones}. */
  tones: readonly (readonly DrawnTone[])[];
  /** The greatest distance of a centre line from its row, bundles aside. */
  offset: number;
  /** The share of their distance by which rows are drawn together to bundles. */
  bundled: number;
  /** The greatest half width. */
  halfWidth: number;
  /**
   * Of rows whose strokes run beside each other, in two lanes: how far each lane lies to its side of the row, and how far the cells of the
   * second are shifted, in cells. 0 for rows of one lane.
   */
  laneOffset: number;
  laneShift: number;
  /** The distance between rows, and the length of a cell that holds one stroke, in millimetres. */
  spacing: number;
  cell: number;
  /** The share of a cell that its stroke fills at most, and how much shorter than that one may be, as a share. */
  filled: number;
  shorter: number;
}

/**
 * The strokes of a hand, with its numbers applied, as profiles: straight rows from which each stroke strays by its own bends. All are
 * oriented as most strokes of their layer were drawn, and have no slope but that of `angleSpread`.
 *
 * @throws TypeError or RangeError with the fault of the hand
 */
export function strokeProfiles(hand: Hand): StrokeProfiles {
  const { shapes, numbers } = runToEnd(prepareHand(hand, 'HatchingMaterial', MOST_PROFILES));
  const chosen = chosenShapes(shapes);
  const { share, filled, shorter, lanes, laneShift, both } = cellOf(numbers);
  const meanWidth = numbers.width * meanOf(chosen, ({ width }) => meanOf([...width], (value) => value));
  const spacing = Math.max(ROW_SPACING * numbers.spacing, (lanes * meanWidth * share) / MOST_INK);
  const laneOffset = lanes === 1 ? 0 : 0.5 * Math.min(MOST_LANE_DISTANCE, (LANE_WIDTHS * meanWidth) / spacing);
  const ofBundles = Math.max(0, numbers.clustering - CLUSTERING_OF_SPREAD * numbers.spacingSpread);
  const bundled = Math.min(MOST_BUNDLED, ofBundles);
  // Bundles have a spread of their own.
  const ownSpread = Math.sqrt(Math.max(0, numbers.spacingSpread ** 2 - spreadOfBundles(bundled) ** 2));
  const stray = Math.min(MOST_STRAY, Math.sqrt(3) * STRAY * ownSpread);
  const turn = (Math.sqrt(3) * numbers.angleSpread * Math.PI) / 180;
  const count = chosen.length;
  const strokes = new Float32Array(2 * PLACES * count);
  let [offset, halfWidth] = [0, 0];
  for (const [row, shape] of chosen.entries()) {
    const [byAngle, byStray] = EVEN.map((step) => 2 * ((row * step) % 1) - 1);
    const rise = 0.5 * shape.length * Math.tan(Math.min(1.2, Math.abs(byAngle) * turn)) * Math.sign(byAngle);
    const bends = withoutArc(shape);
    const line = Array.from({ length: PLACES }, (_, place) => {
      const x = (2 * place) / (PLACES - 1) - 1;
      return (rise * x + shape.length * sampleAt(bends, x)) / spacing + stray * byStray;
    });
    const most = line.reduce((far, value) => Math.max(far, Math.abs(value)), 0);
    const scale = Math.min(1, MOST_OFFSET / (most || 1));
    for (let place = 0; place < PLACES; place++) {
      const x = (2 * place) / (PLACES - 1) - 1;
      const at = 2 * (row * PLACES + place);
      strokes[at] = scale * line[place];
      strokes[at + 1] = Math.min(MOST_HALF_WIDTH, (0.5 * numbers.width * sampleAt(shape.width, x)) / spacing);
      halfWidth = Math.max(halfWidth, strokes[at + 1]);
    }
    offset = Math.max(offset, scale * most);
  }
  const reach = offset + halfWidth + bundled + laneOffset;
  return {
    count,
    strokes,
    tones: drawnTones(strokes, share, Math.min(MOST_WIDENING, MOST_REACH - reach), TONE_ROWS, bundled, {
      offset: laneOffset,
      both,
    }),
    ...{ offset, halfWidth, bundled, laneOffset, laneShift, spacing, filled, shorter },
    cell: numbers.length / share,
  };
}

type Shape = PreparedHand['shapes'][number];

/** The strokes in the order of their swatches, as many of each swatch that was drawn, evenly selected if there are too many. */
function chosenShapes(shapes: readonly Shape[]): Shape[] {
  const swatches = SWATCHES.map((tone) => shapes.filter(({ swatch }) => swatch === tone)).filter(
    ({ length }) => length > 0,
  );
  const each = Math.min(
    Math.floor(MOST_PROFILES / swatches.length),
    swatches.reduce((most, { length }) => Math.max(most, length), 0),
  );
  return swatches.flatMap((swatch) =>
    Array.from(
      { length: each },
      (_, i) => swatch[Math.floor((i * Math.max(swatch.length, each)) / each) % swatch.length],
    ),
  );
}

/** How strokes fill the cells of a row. */
interface FilledCells {
  /** The share of a cell that its stroke fills in the mean, and at most. */
  share: number;
  filled: number;
  /** How much shorter than the longest a stroke may be, as a share: the spread of lengths that cells do not have by themselves. */
  shorter: number;
  lanes: 1 | 2;
  laneShift: number;
  /** The share of the length of a row where both of its lanes have strokes. */
  both: number;
}

/** Strokes of one lane leave the gaps of the hand. Those of two fill more than half of their cells, and run beside each other. */
function cellOf({ overlap, lengthSpread }: HandNumbers): FilledCells {
  const spread = Math.sqrt(Math.max(0, lengthSpread ** 2 - SPREAD_OF_CELLS ** 2));
  // A length uniform in [1 − s, 1] has the mean 1 − s / 2 and the deviation s / √12.
  const shorter = Math.min(1 - SHORTEST, (Math.sqrt(12) * spread) / (1 + Math.sqrt(3) * spread));
  const mean = 1 - 0.5 * shorter;
  const filled = 1 / (1 + Math.max(LEAST_GAP, -overlap));
  if (overlap < LEAST_OVERLAP) return { share: filled * mean, filled, shorter, lanes: 1, laneShift: 0, both: 0 };
  // From an overlap of a half on strokes lie in pairs, whose second begins while the first is drawn.
  const share = Math.min(filled * mean, 0.5 / Math.max(1 - overlap, 0.5) / WHOLE);
  const step = (1 - overlap) * share;
  const both = share - step + Math.max(0, share + step - 1);
  return { share, filled: share / mean, shorter, lanes: 2, laneShift: LANE_STEP * step * WHOLE, both };
}

/** The bends of a stroke around their mean, with a part of its arc. */
function withoutArc({ offset }: Shape): Float32Array {
  const mean = meanOf([...offset], (value) => value);
  let [sum, squares] = [0, 0];
  const arcOf = (i: number): number => {
    const x = (2 * i) / (PROFILE_SAMPLES - 1) - 1;
    return 1 / 3 - x * x;
  };
  for (let i = 0; i < PROFILE_SAMPLES; i++) {
    sum += (offset[i] - mean) * arcOf(i);
    squares += arcOf(i) ** 2;
  }
  return offset.map((value, i) => value - mean - (1 - KEPT_ARC) * (sum / squares) * arcOf(i));
}

/** A value between the samples of a profile, at x from −1 to 1. */
function sampleAt(samples: Float32Array, x: number): number {
  const place = 0.5 * (x + 1) * (samples.length - 1);
  const first = Math.min(samples.length - 2, Math.floor(place));
  return samples[first] + (place - first) * (samples[first + 1] - samples[first]);
}

const meanOf = <Item>(items: readonly Item[], value: (item: Item) => number): number =>
  items.reduce((sum, item) => sum + value(item), 0) / items.length;
