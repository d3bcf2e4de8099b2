import { mix } from '../look/vectors.js';
import { type Chain, ChainBuilder } from './Chain.js';

/** Distance between the starts of dashes on the picture, to within a factor of √2, pixels. */
const PERIOD = 14;
/** The least share of dashes; lines with less are omitted. */
const LEAST_SHARE = 0.12;

/** A line with points where its dashes begin and end. */
class DashedLine {
  private readonly builder = new ChainBuilder();
  private isOn = false;

  constructor(
    private readonly chain: Chain,
    private readonly least: number,
  ) {}

  /** Walks over a piece, from one end of an interval to the other. */
  go(piece: number, from: number, to: number, isOn: boolean): void {
    const isFirst = this.builder.count === 0;
    if (isFirst || isOn !== this.isOn) this.add(piece, from, isFirst && isOn ? 1 : 0);
    this.isOn = isOn;
    // Between two ends with margin 0 a point in the middle decides whether there is a line.
    if (isOn) this.add(piece, 0.5 * (from + to), 1);
    if (to === 1) this.add(piece, 1, isOn ? 1 : -1);
  }

  private add(piece: number, share: number, margin: number): void {
    const { screen, world, halves, triangles } = this.chain;
    const at = (values: Float64Array, size: number): number[] =>
      Array.from({ length: size }, (_, k) => mix(values[size * piece + k], values[size * (piece + 1) + k], share));
    const half = Math.max(at(halves, 1)[0], this.least);
    const triangle = triangles[share === 1 ? Math.min(piece + 1, this.chain.count - 1) : piece];
    this.builder.push(at(screen, 2), at(world, 3), half, margin, triangle);
  }

  finish(): Chain {
    const { hash, field, shifts, isClosed } = this.chain;
    return { ...this.builder.finish(isClosed, hash), field, shifts };
  }
}

/**
 * A line of a print in which parts that are thinner than a press can hold become dashes of the least width with the same tone. Dashes are
 * fixed to the object, so that they stay in place as the camera moves.
 *
 * @param width least width, pixels
 */
export function dashed(chain: Chain, width: number): Chain {
  const least = width / 2;
  const { halves, count, field } = chain;
  if (!field || halves.every((half) => half === 0 || half >= least)) return chain;
  const line = new DashedLine(chain, least);
  for (let piece = 0; piece + 1 < count; piece++) {
    const shares = [halves[piece] / least, halves[piece + 1] / least] as const;
    let from = 0;
    for (const to of breaksOf(chain, piece, shares)) {
      if (to <= from) continue;
      line.go(piece, from, to, isDash(chain, piece, shares, 0.5 * (from + to)));
      from = to;
    }
  }
  return line.finish();
}

/** The phases of the ends of a piece in the pattern of dashes, whose middles are at 0.5 plus an integer; NaN for a piece without length. */
function phases({ field, screen, hash }: Chain, piece: number): readonly [number, number] {
  const [i, j] = [3 * piece, 3 * piece + 3];
  const steps = [0, 1, 2].map((k) => Math.abs(field![j + k] - field![i + k]));
  const most = Math.max(...steps);
  const axis = steps.indexOf(most);
  const length = Math.hypot(screen[2 * piece + 2] - screen[2 * piece], screen[2 * piece + 3] - screen[2 * piece + 1]);
  const period = 2 ** Math.round(Math.log2((PERIOD * most) / length));
  return [field![i + axis] / period + hash, field![j + axis] / period + hash];
}

/** The shares of a piece, rising to 1, at which a dash may begin or end. */
function breaksOf(chain: Chain, piece: number, [a, b]: readonly [number, number]): number[] {
  const breaks = [1];
  const add = (share: number) => {
    if (share > 0 && share < 1) breaks.push(share);
  };
  if (Math.min(a, b) >= 1 || Math.max(a, b) < LEAST_SHARE) return breaks;
  for (const share of [1, LEAST_SHARE]) add((share - a) / (b - a));
  const [start, end] = phases(chain, piece);
  const [low, high] = [Math.floor(Math.min(start, end)) - 1, Math.ceil(Math.max(start, end)) + 1];
  for (let middle = low + 0.5; middle < high; middle++) {
    // Half of a dash is as long as half of its share.
    for (const side of [-0.5, 0.5]) add((middle + side * a - start) / (end - start - side * (b - a)));
  }
  return breaks.sort((x, y) => x - y);
}

function isDash(chain: Chain, piece: number, [a, b]: readonly [number, number], at: number): boolean {
  const share = a + at * (b - a);
  if (share >= 1) return true;
  if (share < LEAST_SHARE) return false;
  const [start, end] = phases(chain, piece);
  const phase = start + at * (end - start);
  return Math.abs(phase - Math.floor(phase) - 0.5) < 0.5 * share;
}

/**
 * Ends an outline or a stroke of a print where it is less than half as wide as a press can hold, and widens the rest to that. Light may
 * still lose parts of it. Changes the chain.
 */
export function endHairlines({ halves, margins, count, outline }: Chain, width: number): void {
  const least = width / 2;
  for (let i = 0; i < count; i++) {
    if (margins[i] > 0) margins[i] = halves[i] / (outline?.points[i].left ?? 1) - 0.5 * least;
    halves[i] = Math.max(halves[i], least);
  }
}
