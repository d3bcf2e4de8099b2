import { smoothstep } from '../../look/vectors.js';
import type { Chain } from '../Chain.js';
import type { Run } from '../visibleRuns.js';

/** An outline with its visible runs. */
export interface SeenOutline {
  chain: Chain;
  runs: Run[];
}

/** Limits, pixels. */
export interface LostLimits {
  /** Shortest line that is left between gaps. */
  shortest: number;
  /** Half the width of the thinnest line. */
  leastHalf: number;
}

/** A line is lost where no more than the first share of its width is left, and back where more than the second is. */
const LOST = 0.3;
const BACK = 0.6;
/** Longest gap as a share of the size of the outlined object, and shortest gap as a share of the longest. */
const LONGEST_GAP = 0.1;
const SHORTEST_GAP = 0.25;
/** The greatest share of the length before paper that gaps take. */
const MOST_LOST = 1 / 3;
/** Length over which a line becomes thinner beside a gap, as a share of the longest gap. */
const EDGE_THINNING = 0.5;

/** A gap in a run, pixels along it. */
interface Gap {
  from: number;
  to: number;
}

const lengthOf = ({ from, to }: Gap): number => to - from;

/**
 * Leaves gaps in the outlines of a body where light nearly takes them: one in each lost stretch, of limited length, with long lines on both
 * sides. Changes runs and widths.
 */
export function loseEdges(outlines: readonly SeenOutline[], limits: LostLimits): void {
  if (!outlines.some(({ chain }) => chain.outline!.points.some(({ left }) => left < LOST))) return;
  const runs = outlines.map((outline) => outline.runs.map((run) => new MeasuredRun(outline.chain, run)));
  const all = runs.flat();
  const longest = LONGEST_GAP * sizeOf(all);
  const shortest = Math.max(SHORTEST_GAP * longest, 0.5 * limits.shortest);
  const found = all.flatMap((run) => run.lost(longest).map((gap) => ({ run, gap })));
  found.sort((a, b) => lengthOf(b.gap) - lengthOf(a.gap));
  let left = MOST_LOST * all.reduce((sum, run) => sum + run.beforePaper(), 0);
  for (const { run, gap } of found) {
    const length = lengthOf(gap);
    if (length < shortest || length > left || !run.hasRoomFor(gap, limits.shortest)) continue;
    run.gaps.push(gap);
    left -= length;
  }
  for (const [i, outline] of outlines.entries()) {
    for (const run of runs[i]) run.thin(EDGE_THINNING * longest, limits.leastHalf);
    outline.runs = runs[i].flatMap((run) => run.parts());
  }
}

/** The larger side of the bounding box of runs, pixels. */
function sizeOf(runs: readonly MeasuredRun[]): number {
  const [low, high] = [
    [Infinity, Infinity],
    [-Infinity, -Infinity],
  ];
  for (const { chain, places } of runs) {
    for (const place of places) {
      for (const k of [0, 1]) {
        const at = valueAt(chain, place, (i) => chain.screen[2 * i + k]);
        low[k] = Math.min(low[k], at);
        high[k] = Math.max(high[k], at);
      }
    }
  }
  return Math.max(high[0] - low[0], high[1] - low[1], 0);
}

/** Interpolates values of points at a place on a chain, which may lie beyond the last point of a closed chain. */
function valueAt({ count }: Chain, place: number, at: (point: number) => number): number {
  const within = place > count - 1 ? place - (count - 1) : place;
  const piece = Math.min(Math.floor(within), count - 2);
  return at(piece) + (within - piece) * (at(piece + 1) - at(piece));
}

/** A visible part of an outline, with the distances of its points along it. */
class MeasuredRun {
  readonly gaps: Gap[] = [];
  /** The places of its points. */
  readonly places: readonly number[];
  /** Their distances along the run, pixels. */
  private readonly along: readonly number[];
  /** Whether it is a whole closed chain, which begins where most of its width is left. */
  private readonly isWhole: boolean;

  constructor(
    readonly chain: Chain,
    readonly run: Run,
  ) {
    const last = chain.count - 1;
    this.isWhole = chain.isClosed && run[0] === 0 && run[1] === last;
    const lefts = chain.outline!.points.map(({ left }) => left);
    const start = this.isWhole ? lefts.indexOf(lefts.reduce((a, b) => Math.max(a, b))) % last : run[0];
    const end = this.isWhole ? start + last : run[1];
    const places = [start];
    for (let place = Math.floor(start) + 1; place < end; place++) places.push(place);
    places.push(end);
    this.places = places;
    const [xs, ys] = [0, 1].map((k) => places.map((place) => valueAt(chain, place, (i) => chain.screen[2 * i + k])));
    let walked = 0;
    this.along = places.map((_, i) => {
      if (i > 0) walked += Math.hypot(xs[i] - xs[i - 1], ys[i] - ys[i - 1]);
      return walked;
    });
  }

  private get length(): number {
    return this.along[this.along.length - 1];
  }

  /** The length of the run before paper, pixels. */
  beforePaper(): number {
    const { chain, places, along } = this;
    const shares = places.map((place) => valueAt(chain, place, (i) => chain.outline!.points[i].contour));
    let sum = 0;
    for (let i = 1; i < places.length; i++) sum += 0.5 * (shares[i - 1] + shares[i]) * (along[i] - along[i - 1]);
    return sum;
  }

  /**
   * The middle part of each lost stretch, no longer than a limit. A stretch ends where the line is back, not where just a little is left.
   */
  lost(longest: number): Gap[] {
    const { chain, places, along } = this;
    const stretches: Gap[] = [];
    let open: Gap | null = null;
    for (const [i, place] of places.entries()) {
      const left = valueAt(chain, place, (k) => chain.outline!.points[k].left);
      if (left < LOST && open) open.to = along[i];
      else if (left < LOST) {
        open = { from: along[i], to: along[i] };
        stretches.push(open);
      } else if (left > BACK) open = null;
    }
    return stretches.map(({ from, to }) => {
      const half = 0.5 * Math.min(to - from, longest);
      return { from: 0.5 * (from + to) - half, to: 0.5 * (from + to) + half };
    });
  }

  /** Whether the line on each side of a gap is as long as the gap, and no shorter than the shortest line. */
  hasRoomFor(gap: Gap, shortest: number): boolean {
    const { gaps, length } = this;
    const room = Math.max(lengthOf(gap), shortest);
    if (gap.from < room || gap.to > length - room) return false;
    return gaps.every((other) => {
      const between = Math.max(gap.from - other.to, other.from - gap.to);
      return between >= Math.max(room, lengthOf(other));
    });
  }

  /** Thins the line towards its gaps over a distance, down to the thinnest. */
  thin(distance: number, leastHalf: number): void {
    const { chain, places, along, gaps } = this;
    if (gaps.length === 0) return;
    const { halves, count } = chain;
    // The place after the last of a closed chain is its first.
    const thinned = new Set<number>();
    for (const [i, place] of places.entries()) {
      const point = place > count - 1 ? place - (count - 1) : place;
      if (!Number.isInteger(point) || thinned.has(point)) continue;
      thinned.add(point);
      const away = Math.min(...gaps.map(({ from, to }) => Math.max(from - along[i], along[i] - to)));
      halves[point] = Math.max(halves[point] * smoothstep(0, distance, away), leastHalf);
    }
    if (chain.isClosed) halves[0] = halves[count - 1] = Math.min(halves[0], halves[count - 1]);
  }

  /** The run without its gaps. */
  parts(): Run[] {
    const { chain, places, gaps, isWhole, run } = this;
    if (gaps.length === 0) return [run];
    gaps.sort((a, b) => a.from - b.from);
    const last = chain.count - 1;
    const ends = [places[0], ...gaps.flatMap(({ from, to }) => [from, to].map((at) => this.placeAt(at)))];
    ends.push(places[places.length - 1]);
    const parts: Run[] = [];
    for (let i = 0; i < ends.length; i += 2) parts.push([ends[i], ends[i + 1]]);
    if (!isWhole) return parts;
    const [from] = parts.pop()!;
    const [, to] = parts.shift()!;
    return [...parts, from > last ? [from - last, to] : [from, to + last]];
  }

  private placeAt(at: number): number {
    const { along, places } = this;
    const after = Math.max(
      along.findIndex((one) => one >= at),
      1,
    );
    const share = (at - along[after - 1]) / (along[after] - along[after - 1] || 1);
    return places[after - 1] + share * (places[after] - places[after - 1]);
  }
}
