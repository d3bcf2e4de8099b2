/**
 * The lines of one family as a pen of one width draws them, spaced by the tone. Old lines are the multiples of a power of two; between two
 * octaves of spacing as many new lines are added as the tone needs. All may move aside a little, so that they are evenly spaced.
 */
import { clamp01 } from '../../look/vectors.js';

/** Number of gaps between old lines that share the room of the new ones. */
const WINDOW = 8;
/** The order in which the gaps of a window are filled: those farthest from all others come first. */
const ORDER = [0, 4, 2, 6, 1, 5, 3, 7];
/** The part of the interval between two new lines over which lines move aside, on either side of it. */
const EASE = 0.25;

/** The van der Corput sequence in [0, 1). bits: of the number that count. */
function evenlySpread(number: number, bits: number): number {
  let sum = 0;
  for (let bit = 0; bit < bits; bit++) sum += ((number >> bit) & 1) / 2 ** (bit + 1);
  return sum;
}

/** The octave of old lines for a spacing. */
const topOf = (spacing: number): number => Math.ceil(Math.log2(spacing));

/**
 * The density of lines, relative to old ones, at which the line in a gap of a window appears. Windows differ, so that their mean is the
 * tone.
 */
const birthAt = (gap: number, window: number): number =>
  1 + (ORDER[gap] + 1 - (evenlySpread(window, 3) + 1 / 16)) / WINDOW;

/** The offset of a line from its value, units of the function. spacing: of lines there, in the same unit. */
export function evenOffset(value: number, spacing: number): number {
  const unit = 2 ** topOf(spacing);
  const density = unit / spacing;
  const window = Math.floor(value / (WINDOW * unit));
  const slot = value / unit - WINDOW * window;
  // The room of each new line grows from 0 to 1 as it appears.
  let [below, all] = [slot, WINDOW];
  for (let gap = 0; gap < WINDOW; gap++) {
    const birth = birthAt(gap, window);
    const ease = Math.min(EASE / WINDOW, birth - 1, 2 - birth);
    const room = clamp01(0.5 + (0.5 * (density - birth)) / ease);
    all += room;
    below += room * clamp01(slot - gap);
  }
  return unit * ((WINDOW * below) / all - slot);
}

/**
 * Above 0 where a line is drawn.
 *
 * @param rank the power of two in its value, as an exponent
 * @param isEven whether lines move aside; otherwise the ends of neighbours are spread as far as possible
 */
export function penMargin(value: number, rank: number, spacing: number, isEven: boolean): number {
  const top = topOf(spacing);
  if (rank >= top) return 1;
  if (rank < top - 1) return -1;
  const unit = 2 ** top;
  const gap = Math.floor(value / unit);
  const birth = isEven
    ? birthAt(((gap % WINDOW) + WINDOW) % WINDOW, Math.floor(gap / WINDOW))
    : 1 + evenlySpread(gap, 16);
  return unit / spacing - birth;
}
