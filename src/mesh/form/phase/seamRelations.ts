import { nextCorner } from '../../corners.js';
import { asPhase, chunkPhase, forEachChunk } from '../../phases.js';
import type { FormSeam } from '../cutForm.js';
import type { FormSurface } from '../FormSurface.js';
import { bindJumps, type FreeJumps, freeJumps, type JumpEquations, releaseJumps } from './freeJumps.js';

/** The offset of a wedge without one, and the origin of an offset without one. */
export const NO_OFFSET = -1;

/**
 * How φ at the wedges follows from one value per fan and from the free jumps: φ = sign · (value of the fan) + offset. The first
 * wedge of a fan has no offset; where a walk around the fan crosses the cut, φ′ = sφ + j gives those of the others. At a singular
 * point φ = −φ + Σ ±j once around: its sign is 0, and the offset of its first wedge is half of the sum. Offsets that are the same
 * sums have one number.
 */
export interface SeamRelations {
  /** For each wedge 1, −1 or 0. */
  signs: Int8Array;
  /** For each wedge the number of its offset, or NO_OFFSET. */
  ofWedge: Int32Array;
  /** For each offset an earlier one that it contains, or NO_OFFSET, and the sign with which it does. */
  origins: Int32Array;
  originSigns: Int8Array;
  /** Offset i also contains terms starts[i] … starts[i + 1] − 1: jumps of segments, with factors. */
  starts: Uint32Array;
  segments: Uint32Array;
  factors: Float32Array;
  /** The number of segments of the cut. */
  segmentCount: number;
  jumps: FreeJumps;
}

/** The relations while they are being collected. */
interface Collection {
  surface: FormSurface;
  seam: FormSeam;
  cut: CutSegments;
  signs: Int8Array;
  ofWedge: Int32Array;
  origins: number[];
  originSigns: number[];
  starts: number[];
  segments: number[];
  factors: number[];
  /** The number of each offset, by its terms. */
  known: Map<string, number>;
  equations: JumpEquations;
}

/** A jump of a segment, with its factor. */
type Term = readonly [segment: number, factor: number];

/** Finds the relations by a walk around each fan of the cut. */
export function* seamRelations(surface: FormSurface, seam: FormSeam): Generator<number, SeamRelations, void> {
  const cut = yield* asPhase(cutSegments(surface, seam), 0, 0.4);
  const { degree, wedges } = seam;
  const collection: Collection = {
    surface,
    seam,
    cut,
    signs: new Int8Array(wedges.count).fill(1),
    ofWedge: new Int32Array(wedges.count).fill(NO_OFFSET),
    origins: [],
    originSigns: [],
    starts: [0],
    segments: [],
    factors: [],
    known: new Map(),
    equations: { starts: [0], segments: [], signs: [] },
  };
  yield* chunkPhase(surface.fans.count, 0.4, 0.8, (start, end) => {
    for (let fan = start; fan < end; fan++) if (degree[fan] > 0) relateWedges(collection, fan);
  });
  const jumps = freeJumps(collection.equations, cut.count);
  yield 1;
  return {
    signs: collection.signs,
    ofWedge: collection.ofWedge,
    origins: Int32Array.from(collection.origins),
    originSigns: Int8Array.from(collection.originSigns),
    starts: Uint32Array.from(collection.starts),
    segments: Uint32Array.from(collection.segments),
    factors: Float32Array.from(collection.factors),
    segmentCount: cut.count,
    jumps,
  };
}

/** Relates each wedge of a fan to the one before. */
function relateWedges(collection: Collection, fan: number): void {
  const { surface, seam, cut, signs, ofWedge, equations } = collection;
  const { twins } = surface;
  const { cutSign, wedges, isOpen, isPuncture } = seam;
  const first = firstCorner(surface, seam, fan);
  const crossed = crossedEdges(surface, seam, first);
  let wedge = wedges.ofCorner[first];
  if (isOpen[fan] === 0) {
    const terms = jumpsAround(cut, seam, crossed);
    const around = crossed.reduce((sign, edge) => sign * cutSign[edge], 1);
    if (around < 0) {
      signs[wedge] = 0;
      const half = terms.map(([segment, sign]): Term => [segment, sign / 2]);
      ofWedge[wedge] = enterOffset(collection, NO_OFFSET, 1, half);
    } else if (isPuncture[fan] === 0 && !cancels(terms)) {
      for (const [segment, sign] of terms) {
        equations.segments.push(segment);
        equations.signs.push(sign);
      }
      equations.starts.push(equations.segments.length);
    }
    // The last edge returns to the first wedge.
    crossed.pop();
  }
  for (const edge of crossed) {
    const next = wedges.ofCorner[nextCorner(twins[edge])];
    signs[next] = cutSign[edge] * signs[wedge];
    const jump: Term = [cut.ofEdge[edge], cut.signs[edge]];
    ofWedge[next] = enterOffset(collection, ofWedge[wedge], cutSign[edge], [jump]);
    wedge = next;
  }
}

/**
 * Enters an offset, and returns its number. Along a segment all wedges have the same one, so that edges between the same cells become one edge on
 * coarser levels.
 */
function enterOffset(collection: Collection, origin: number, originSign: number, terms: readonly Term[]): number {
  const { known, origins, originSigns, starts, segments, factors } = collection;
  const key = [origin, originSign, ...terms.flat()].join();
  const before = known.get(key);
  if (before !== undefined) return before;
  const offset = origins.length;
  known.set(key, offset);
  origins.push(origin);
  originSigns.push(originSign);
  for (const [segment, factor] of terms) {
    segments.push(segment);
    factors.push(factor);
  }
  starts.push(segments.length);
  return offset;
}

/** The corner where a walk around a fan of the cut begins: at the border, or just behind a cut edge. */
function firstCorner({ twins }: FormSurface, { cut, cornerOf, isOpen }: FormSeam, fan: number): number {
  let corner = cornerOf[fan];
  if (isOpen[fan] === 1) return corner;
  while (cut[corner] === 0) corner = nextCorner(twins[corner]);
  return nextCorner(twins[corner]);
}

/** The cut edges that a walk around a fan crosses, in their order. */
function crossedEdges({ twins }: FormSurface, { cut }: FormSeam, first: number): number[] {
  const crossed: number[] = [];
  let corner = first;
  do {
    if (cut[corner] === 1) crossed.push(corner);
    if (twins[corner] < 0) break;
    corner = nextCorner(twins[corner]);
  } while (corner !== first);
  return crossed;
}

/** The terms of the jump of φ on a walk around a closed fan. */
function jumpsAround(cut: CutSegments, { cutSign }: FormSeam, crossed: readonly number[]): Term[] {
  let sign = 1;
  return crossed.toReversed().map((edge) => {
    const term: Term = [cut.ofEdge[edge], sign * cut.signs[edge]];
    sign *= cutSign[edge];
    return term;
  });
}

/** Whether the two terms of a segment that passes through cancel each other. */
const cancels = (terms: readonly Term[]): boolean =>
  terms.length === 2 && terms[0][0] === terms[1][0] && terms[0][1] === -terms[1][1];

/** Computes the offsets from the jumps. Both have two values for each, one per family of lines; only free jumps are read. */
export function offsetsOf(relations: SeamRelations, jumps: Float64Array, offsets: Float64Array): void {
  const { origins, originSigns, starts, segments, factors } = relations;
  bindJumps(relations.jumps, jumps);
  for (let i = 0; i < origins.length; i++) {
    const origin = 2 * origins[i];
    let sum = origin < 0 ? 0 : originSigns[i] * offsets[origin];
    let sum2 = origin < 0 ? 0 : originSigns[i] * offsets[origin + 1];
    for (let term = starts[i]; term < starts[i + 1]; term++) {
      const segment = 2 * segments[term];
      sum += factors[term] * jumps[segment];
      sum2 += factors[term] * jumps[segment + 1];
    }
    offsets[2 * i] = sum;
    offsets[2 * i + 1] = sum2;
  }
}

/** The transpose of `offsetsOf`: adds up forces on the offsets to forces on the free jumps. Overwrites `offsetPulls`. */
export function jumpPulls(relations: SeamRelations, offsetPulls: Float64Array, pulls: Float64Array): void {
  const { origins, originSigns, starts, segments, factors } = relations;
  pulls.fill(0);
  for (let i = origins.length - 1; i >= 0; i--) {
    const origin = 2 * origins[i];
    const pull = offsetPulls[2 * i];
    const pull2 = offsetPulls[2 * i + 1];
    if (origin >= 0) {
      offsetPulls[origin] += originSigns[i] * pull;
      offsetPulls[origin + 1] += originSigns[i] * pull2;
    }
    for (let term = starts[i]; term < starts[i + 1]; term++) {
      const segment = 2 * segments[term];
      pulls[segment] += factors[term] * pull;
      pulls[segment + 1] += factors[term] * pull2;
    }
  }
  releaseJumps(relations.jumps, pulls);
}

/** The segment of an edge that is not cut. */
const NO_SEGMENT = -1;

/**
 * The cut, divided at its ends and junctions into segments. Across each segment φ′ = sφ + j with one jump j, where s is the sign
 * of the edge (`cutSign`).
 */
interface CutSegments {
  count: number;
  /** For each edge its segment, or NO_SEGMENT. */
  ofEdge: Int32Array;
  /** For each cut edge 1 or −1: the jump from its own face to that of its twin, in terms of the jump of its segment. */
  signs: Int8Array;
}

/** Divides the cut into segments. A closed one begins anywhere. */
function* cutSegments(
  { twins, fans: { ofCorner, count: fanCount } }: FormSurface,
  seam: FormSeam,
): Generator<number, CutSegments, void> {
  const { degree } = seam;
  const cornerCount = twins.length;
  const walk: SegmentWalk = {
    twins,
    ofCorner,
    seam,
    segments: { count: 0, ofEdge: new Int32Array(cornerCount).fill(NO_SEGMENT), signs: new Int8Array(cornerCount) },
  };
  yield* forEachChunk(fanCount, (start, end) => {
    for (let fan = start; fan < end; fan++) if (degree[fan] > 0 && endsSegments(seam, fan)) beginSegments(walk, fan);
  });
  // The remaining segments are closed.
  yield* forEachChunk(fanCount, (start, end) => {
    for (let fan = start; fan < end; fan++) if (degree[fan] > 0) beginSegments(walk, fan);
  });
  return walk.segments;
}

interface SegmentWalk {
  twins: Int32Array;
  ofCorner: Uint32Array;
  seam: FormSeam;
  segments: CutSegments;
}

/** Whether segments end at a fan of the cut. Elsewhere the jumps into and out of a fan cancel. */
const endsSegments = ({ degree, isSingular, isPuncture, isOpen }: FormSeam, fan: number): boolean =>
  degree[fan] !== 2 || isSingular[fan] === 1 || isPuncture[fan] === 1 || isOpen[fan] === 1;

/** Starts a segment at each cut edge of a fan that has none. */
function beginSegments(walk: SegmentWalk, fan: number): void {
  const { twins, seam, segments } = walk;
  const first = seam.cornerOf[fan];
  let corner = first;
  do {
    if (seam.cut[corner] === 1 && segments.ofEdge[corner] === NO_SEGMENT) walkSegment(walk, corner);
    corner = twins[corner] < 0 ? first : nextCorner(twins[corner]);
  } while (corner !== first);
}

/** Follows the cut from the edge that starts at `first`, until a fan where segments end, or until it is closed. */
function walkSegment({ twins, ofCorner, seam, segments }: SegmentWalk, first: number): void {
  const { cutSign } = seam;
  const { ofEdge, signs } = segments;
  const segment = segments.count++;
  let sign = 1;
  for (let edge = first; ; ) {
    const twin = twins[edge];
    ofEdge[edge] = ofEdge[twin] = segment;
    signs[edge] = sign;
    signs[twin] = -cutSign[edge] * sign;
    const fan = ofCorner[nextCorner(edge)];
    if (endsSegments(seam, fan)) return;
    // A walk around the fan crosses the twin into one wedge and the next edge back out of it, so one jump is −s times the other.
    const next = otherCutEdge(twins, seam, fan, twin);
    if (ofEdge[next] !== NO_SEGMENT) return;
    sign = -cutSign[next] * signs[twin];
    edge = next;
  }
}

/** The cut edge that starts at a fan of two, and is not `edge`. */
function otherCutEdge(twins: Int32Array, { cut, cornerOf }: FormSeam, fan: number, edge: number): number {
  const first = cornerOf[fan];
  let corner = first;
  while (cut[corner] === 0 || corner === edge) corner = nextCorner(twins[corner]);
  return corner;
}
