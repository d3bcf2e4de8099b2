import { NO_TWIN, nextCorner, previousCorner, triangleOf } from '../corners.js';
import { buildFans, type Fans } from '../normals/fans.js';
import { asPhase, chunkPhase } from '../phases.js';
import { combFaces } from './combFaces.js';
import type { FaceDirections } from './directions/faceDirections.js';
import type { FormSurface } from './FormSurface.js';

/**
 * The surface cut open so that directions can be combed: on the cut surface they have signs that agree across every edge. Edges
 * and corners share their numbers (see `corners.ts`).
 */
export interface FormSeam {
  /** The sign of each face's direction after combing, 1 or −1. */
  flip: Int8Array<ArrayBuffer>;
  /** For each edge 1 if the surface is cut there, else 0. Both halves of an edge have the same. */
  cut: Uint8Array<ArrayBuffer>;
  /** For each cut edge 1 or −1: whether combed directions on its two sides agree. 1 for all others. Both halves have the same. */
  cutSign: Int8Array<ArrayBuffer>;
  /** The twins of the surface, with NO_TWIN where it is cut. */
  cutTwins: Int32Array<ArrayBuffer>;
  /** The fans of `cutTwins`: the vertices of φ. */
  wedges: Fans;
  /** For each fan how often directions turn around it, in half turns: 1 or −1 at most singular points, 0 at regular fans and open ones. */
  halfTurns: Int8Array<ArrayBuffer>;
  /** For each fan 1 if directions turn by an odd number of half turns around it, so that they come back reversed. */
  isSingular: Uint8Array<ArrayBuffer>;
  /** For each fan 1 if directions turn by whole turns around it: a hole for φ, which has no value there. */
  isPuncture: Uint8Array<ArrayBuffer>;
  /** For each fan 1 if it lies on a border or a crease. */
  isOpen: Uint8Array<ArrayBuffer>;
  /** For each fan the number of cut edges that meet there. */
  degree: Uint32Array<ArrayBuffer>;
  /** For each fan the corner from which a walk across the edges that start there, from `corner` to `nextCorner(twins[corner])`, meets the whole fan. */
  cornerOf: Int32Array<ArrayBuffer>;
}

/**
 * Combs the directions of the faces, finds the singular points around which that is impossible, and cuts the surface along the part of the
 * complement of a tree that joins singular points, borders and handles. The rest can be combed.
 */
export function* cutForm(
  surface: Pick<FormSurface, 'twins' | 'fans' | 'heat'>,
  directions: FaceDirections,
): Generator<number, FormSeam, void> {
  const { twins, fans } = surface;
  const edgeCount = twins.length;
  const signs = new Int8Array(edgeCount).fill(1);
  const turns = new Float32Array(fans.count);
  yield* chunkPhase(edgeCount, 0, 0.4, (start, end) =>
    turnRange(twins, fans.ofCorner, directions, signs, turns, start, end),
  );
  const points = yield* asPhase(classifyFans(twins, fans, signs, turns), 0.4, 0.5);
  const { isSingular, isPuncture, isOpen } = points;
  const isEnd = (fan: number) => isSingular[fan] + isPuncture[fan] + isOpen[fan] > 0;
  const { flip, cut } = yield* asPhase(combFaces(surface, signs, isEnd), 0.5, 0.7);
  const degree = yield* asPhase(trimCut(twins, fans, points, cut), 0.7, 0.8);
  const cutTwins = twins.slice();
  const cutSign = new Int8Array(edgeCount).fill(1);
  yield* chunkPhase(edgeCount, 0.8, 0.9, (start, end) =>
    openRange(twins, signs, flip, cut, cutTwins, cutSign, start, end),
  );
  const wedges = yield* asPhase(buildFans(cutTwins), 0.9, 1);
  return { flip, cut, cutSign, cutTwins, wedges, degree, ...points };
}

/** Bound on the denominator for opposite normals, between which no rotation is the shortest. */
const LEAST_ROTATION = 1e-3;

/**
 * Writes for each edge of a range the sign by which the two directions beside it agree, and adds to each fan the angles by which
 * they turn from face to face around it. The direction across the edge is carried over by the shortest rotation of its normal.
 */
function turnRange(
  twins: Int32Array,
  ofCorner: Uint32Array,
  { across, normals }: FaceDirections,
  signs: Int8Array,
  turns: Float32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const twin = twins[corner];
    // Each edge is measured once, from its later half-edge.
    if (twin === NO_TWIN || twin > corner) continue;
    const f = corner - (corner % 3);
    const g = twin - (twin % 3);
    const nx = normals[f];
    const ny = normals[f + 1];
    const nz = normals[f + 2];
    const mx = normals[g] + nx;
    const my = normals[g + 1] + ny;
    const mz = normals[g + 2] + nz;
    const scale =
      (across[g] * nx + across[g + 1] * ny + across[g + 2] * nz) /
      Math.max(nx * mx + ny * my + nz * mz, LEAST_ROTATION);
    const x = across[g] - scale * mx;
    const y = across[g + 1] - scale * my;
    const z = across[g + 2] - scale * mz;
    const ux = across[f];
    const uy = across[f + 1];
    const uz = across[f + 2];
    const cosine = ux * x + uy * y + uz * z;
    const sine = nx * (uy * z - uz * y) + ny * (uz * x - ux * z) + nz * (ux * y - uy * x);
    const sign = cosine < 0 ? -1 : 1;
    const angle = Math.atan2(sign * sine, sign * cosine);
    signs[corner] = sign;
    signs[twin] = sign;
    // Seen from outside, the walk from this face to the other one is clockwise around the fan where the edge starts.
    turns[ofCorner[corner]] -= angle;
    turns[ofCorner[twin]] += angle;
  }
}

/** The members of `FormSeam` that describe fans before the surface is cut. */
type FanPoints = Pick<FormSeam, 'halfTurns' | 'isSingular' | 'isPuncture' | 'isOpen' | 'cornerOf'>;

/** Finds singular points. The product of the signs around a fan gives the parity of its half turns, the angles give their number. */
function* classifyFans(
  twins: Int32Array,
  { ofCorner, count }: Fans,
  signs: Int8Array,
  turns: Float32Array,
): Generator<number, FanPoints, void> {
  const points: FanPoints = {
    halfTurns: new Int8Array(count),
    isSingular: new Uint8Array(count),
    isPuncture: new Uint8Array(count),
    isOpen: new Uint8Array(count),
    cornerOf: new Int32Array(count).fill(NO_TWIN),
  };
  yield* chunkPhase(twins.length, 0, 0.7, (start, end) => visitCorners(twins, ofCorner, signs, points, start, end));
  yield* chunkPhase(count, 0.7, 1, (start, end) => countTurns(turns, points, start, end));
  return points;
}

function visitCorners(
  twins: Int32Array,
  ofCorner: Uint32Array,
  signs: Int8Array,
  { isSingular, isOpen, cornerOf }: FanPoints,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    const fan = ofCorner[corner];
    if (signs[corner] < 0) isSingular[fan] ^= 1;
    if (twins[corner] === NO_TWIN) isOpen[fan] = 1;
    const isFirst = twins[previousCorner(corner)] === NO_TWIN;
    if (isFirst) isOpen[fan] = 1;
    if (isFirst || cornerOf[fan] < 0) cornerOf[fan] = corner;
  }
}

function countTurns(
  turns: Float32Array,
  { halfTurns, isSingular, isPuncture, isOpen }: FanPoints,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    if (isOpen[fan] === 1) {
      isSingular[fan] = 0;
      continue;
    }
    const odd = isSingular[fan];
    halfTurns[fan] = 2 * Math.round((turns[fan] / Math.PI - odd) / 2) + odd;
    if (odd === 0 && halfTurns[fan] !== 0) isPuncture[fan] = 1;
  }
}

/**
 * Closes the blind ends of the cut, in place: those that end neither in a singular point nor at a border.
 *
 * @returns for each fan the number of cut edges that are left
 */
function* trimCut(
  twins: Int32Array,
  { ofCorner, count }: Fans,
  points: FanPoints,
  cut: Uint8Array,
): Generator<number, Uint32Array<ArrayBuffer>, void> {
  const degree = new Uint32Array(count);
  yield* chunkPhase(cut.length, 0, 0.5, (start, end) => countRange(ofCorner, cut, degree, start, end));
  yield* chunkPhase(count, 0.5, 1, (start, end) => trimRange(twins, ofCorner, points, cut, degree, start, end));
  return degree;
}

/** Both halves of an edge are cut; each counts for the fan that it starts from. */
function countRange(ofCorner: Uint32Array, cut: Uint8Array, degree: Uint32Array, start: number, end: number): void {
  for (let corner = start; corner < end; corner++) degree[ofCorner[corner]] += cut[corner];
}

/** Closes the blind ends that begin in a range of fans. */
function trimRange(
  twins: Int32Array,
  ofCorner: Uint32Array,
  { isSingular, isPuncture, isOpen, cornerOf }: FanPoints,
  cut: Uint8Array,
  degree: Uint32Array,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    let blind = fan;
    while (degree[blind] === 1 && isSingular[blind] === 0 && isPuncture[blind] === 0 && isOpen[blind] === 0) {
      const corner = cutEdgeFrom(twins, cut, cornerOf[blind]);
      cut[corner] = cut[twins[corner]] = 0;
      degree[blind] = 0;
      blind = ofCorner[nextCorner(corner)];
      degree[blind]--;
    }
  }
}

/** The only cut edge of a closed fan, found by a walk around it. */
function cutEdgeFrom(twins: Int32Array, cut: Uint8Array, first: number): number {
  let corner = first;
  while (cut[corner] === 0) corner = nextCorner(twins[corner]);
  return corner;
}

function openRange(
  twins: Int32Array,
  signs: Int8Array,
  flip: Int8Array,
  cut: Uint8Array,
  cutTwins: Int32Array,
  cutSign: Int8Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) {
    if (cut[corner] === 0) continue;
    cutTwins[corner] = NO_TWIN;
    cutSign[corner] = signs[corner] * flip[triangleOf(corner)] * flip[triangleOf(twins[corner])];
  }
}
