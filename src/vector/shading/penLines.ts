/**
 * Lines of one family that a pen of one width draws: as far apart as the tone asks for. There is one for every multiple of a power of two, and
 * between two octaves of distance as many of the young ones as that takes. They may all move aside a little, so that they are evenly apart.
 */
import { clamp01 } from '../../look/vectors.js';

/** So many old lines share the room of those that are born between them. */
const WINDOW = 8;
/** The order in which the lines of a window are born: the place of each gap in it. Those come first that are farthest from all others. */
const ORDER = [0, 4, 2, 6, 1, 5, 3, 7];
/** Over how much of the way from one birth to the next lines move aside, on either side of it. */
const EASE = 0.25;

/** A number in [0, 1) that spreads whole numbers evenly (van der Corput). bits: of them that count. */
function evenlySpread(number: number, bits: number): number {
  let sum = 0;
  for (let bit = 0; bit < bits; bit++) sum += ((number >> bit) & 1) / 2 ** (bit + 1);
  return sum;
}

/** The octave of the distance of old lines, where lines are asked to be so far apart. */
const topOf = (spacing: number): number => Math.ceil(Math.log2(spacing));

/** The density of lines, of old ones alone 1, at which that in a gap of a window is born. Windows differ, so that their mean is the tone. */
const birthAt = (gap: number, window: number): number =>
  1 + (ORDER[gap] + 1 - (evenlySpread(window, 3) + 1 / 16)) / WINDOW;

/** How far a line is moved aside from its value, units of the function. spacing: that lines are asked to have there, in the same unit. */
export function asideOf(value: number, spacing: number): number {
  const unit = 2 ** topOf(spacing);
  const density = unit / spacing;
  const window = Math.floor(value / (WINDOW * unit));
  const slot = value / unit - WINDOW * window;
  // The room of each young line grows from 0 to 1 when it is born.
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
 * Where this is above 0, a line is drawn.
 *
 * @param rank the power of two in its value, as an exponent
 * @param isEven whether lines move aside; otherwise the ends of neighbours are spread as far as can be
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
