import type { Chain } from './Chain.js';
import type { Projection } from './Projection.js';

/** A part of a chain, from place to place. A place is the index of a point plus a share of the piece after it, on the picture. */
export type Run = readonly [from: number, to: number];

/** A test whether a place on a chain is visible, by its positions in the world and on the picture. */
export type SeenTest = (place: ChainPlace) => boolean;

/** A place on a chain. */
export interface ChainPlace {
  world: readonly [number, number, number];
  x: number;
  y: number;
  /** The index of the point before, and the share of the piece. */
  piece: number;
  share: number;
}

/** Distance between samples, and the precision at which the ends of runs are found. Pixels. */
const STEP = 0.5;
const TOLERANCE = 0.005;
const MOST_HALVINGS = 24;
/** Samples per step. */
const LOOKS_AT_ONCE = 128;

/** The place on a chain at a share of a piece. */
export function placeOn({ screen, world }: Chain, piece: number, share: number, projection: Projection): ChainPlace {
  const [i, j] = [3 * piece, 3 * piece + 3];
  const x = screen[2 * piece] + share * (screen[2 * piece + 2] - screen[2 * piece]);
  const y = screen[2 * piece + 1] + share * (screen[2 * piece + 3] - screen[2 * piece + 1]);
  if (share === 0) return { world: [world[i], world[i + 1], world[i + 2]], x, y, piece, share };
  const start = projection.depthOf(world[i], world[i + 1], world[i + 2]);
  const end = projection.depthOf(world[j], world[j + 1], world[j + 2]);
  const t = projection.shareInSpace(share, start, end);
  const at = (k: number) => world[i + k] + t * (world[j + k] - world[i + k]);
  return { world: [at(0), at(1), at(2)], x, y, piece, share };
}

/** The parts of a chain that have a line, lie on the picture and are visible. Yields its progress. */
export function* visibleRuns(chain: Chain, projection: Projection, isSeen: SeenTest): Generator<number, Run[], void> {
  const sampler = new RunSampler(chain, projection, isSeen);
  for (const [from, to] of linedParts(chain)) yield* sampler.sample(from, to);
  return joinedAtStart(chain, sampler.runs);
}

/** The parts with a margin above 0. */
function linedParts({ margins, count }: Chain): Run[] {
  const parts: Run[] = [];
  let open = margins[0] > 0 ? 0 : -1;
  for (let i = 0; i + 1 < count; i++) {
    const [a, b] = [margins[i], margins[i + 1]];
    if (a > 0 === b > 0) continue;
    const place = i + a / (a - b);
    if (a > 0) parts.push([open, place]);
    else open = place;
  }
  if (margins[count - 1] > 0) parts.push([open, count - 1]);
  return parts;
}

/** In a closed chain the last run continues in the first: it then ends beyond the last point. */
function joinedAtStart({ isClosed, count }: Chain, runs: Run[]): Run[] {
  const last = count - 1;
  if (!isClosed || runs.length < 2) return runs;
  const [first] = runs;
  const final = runs[runs.length - 1];
  if (first[0] !== 0 || final[1] !== last) return runs;
  return [...runs.slice(1, -1), [final[0], last + first[1]]];
}

class RunSampler {
  readonly runs: Run[] = [];

  constructor(
    private readonly chain: Chain,
    private readonly projection: Projection,
    private readonly isSeen: SeenTest,
  ) {}

  *sample(from: number, to: number): Generator<number, void, void> {
    let looked = 0;
    let last = from;
    let wasSeen = this.isSeenAt(from);
    let begin = from;
    for (const place of this.placesBetween(from, to)) {
      if (++looked % LOOKS_AT_ONCE === 0) yield place / this.chain.count;
      const isSeen = this.isSeenAt(place);
      if (isSeen !== wasSeen) {
        const border = this.borderBetween(last, place, wasSeen);
        if (wasSeen) this.add(begin, border);
        else begin = border;
      }
      wasSeen = isSeen;
      last = place;
    }
    if (wasSeen) this.add(begin, to);
  }

  private add(from: number, to: number): void {
    if (to > from) this.runs.push([from, to]);
  }

  private isSeenAt(place: number): boolean {
    const piece = Math.min(Math.floor(place), this.chain.count - 2);
    const at = placeOn(this.chain, piece, place - piece, this.projection);
    return this.projection.contains(at.x, at.y) && this.isSeen(at);
  }

  /** Samples after the first, about a step apart; the last is the end. */
  private *placesBetween(from: number, to: number): Generator<number, void, void> {
    let rest = STEP;
    for (let i = Math.floor(from); i < to; i++) {
      const [start, end] = [Math.max(from, i), Math.min(to, i + 1)];
      const whole = this.lengthOf(i);
      let walked = rest;
      for (; walked < (end - start) * whole; walked += STEP) yield start + walked / whole;
      rest = walked - (end - start) * whole;
    }
    yield to;
  }

  private lengthOf(piece: number): number {
    const { screen } = this.chain;
    return Math.hypot(screen[2 * piece + 2] - screen[2 * piece], screen[2 * piece + 3] - screen[2 * piece + 1]);
  }

  private borderBetween(a: number, b: number, isSeenAtA: boolean): number {
    let [low, high] = [a, b];
    for (let i = 0; i < MOST_HALVINGS; i++) {
      // Pieces differ in length, so a distance is only known within one of them.
      const piece = Math.min(Math.floor(low), this.chain.count - 2);
      if (high <= piece + 1 && (high - low) * this.lengthOf(piece) < TOLERANCE) break;
      const middle = 0.5 * (low + high);
      if (this.isSeenAt(middle) === isSeenAtA) low = middle;
      else high = middle;
    }
    return 0.5 * (low + high);
  }
}
