import { nextCorner } from '../corners.js';
import { forEachChunk } from '../phases.js';
import type { FormSeam } from './cutForm.js';
import type { FormSurface } from './FormSurface.js';

/** The segment of an edge that is not cut. */
export const NO_SEGMENT = -1;

/**
 * The cut, divided at its ends and junctions into segments. Across each segment φ′ = sφ + j with one jump j, where s is the sign
 * of the edge (`cutSign`).
 */
export interface CutSegments {
  count: number;
  /** For each edge its segment, or NO_SEGMENT. */
  ofEdge: Int32Array;
  /** For each cut edge 1 or −1: the jump from its own face to that of its twin, in terms of the jump of its segment. */
  signs: Int8Array;
}

/** Divides the cut into segments. A closed one begins anywhere. */
export function* cutSegments(
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
