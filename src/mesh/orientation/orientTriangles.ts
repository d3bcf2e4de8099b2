import { computeAreaNormals } from '../computeAreaNormals.js';
import { asPhase } from '../phases.js';
import { type TriangleMesh, validateTriangleMesh } from '../TriangleMesh.js';
import { weldPositions } from '../weldPositions.js';
import { consistentPatches, NO_PATCH, type Patches } from './consistentPatches.js';
import { type SideVotes, sideVotes } from './sideVotes.js';

/** How much less a patch must be seen from its front than from its back for it to be turned. Others count as seen from both sides. */
const LEAST_SHARE = 0.56;
/** The fewest pixels, over all directions, that tell the side of a patch. */
const LEAST_VOTES = 4;
/** A patch counts as hidden if less than this share of it is seen. The bottom of a thing on the floor of a room may be. */
const HIDDEN = 0.25;

/** A patch with what decides which way it faces. */
interface Part {
  isClosed: boolean;
  least: number[];
  most: number[];
  /** Six times the volume that a closed patch encloses, negative if it faces inward; of an open one 0. */
  volume: number;
  doubleArea: number;
}

/**
 * Finds the triangles that face the wrong way, in a mesh from a file that promises nothing: patches whose windings contradict each other,
 * closed patches that face inward, and open ones that are seen from their back. Nothing is turned that is right:
 *
 * - a closed patch that another one hides is left as most of it is: it may be the wall of a cavity;
 * - a closed patch that hides others, such as a room with its furniture, is left unless they face inward too;
 * - an open patch that is seen about as much from both sides is left as most of it is.
 *
 * @returns for each triangle 1 if two of its corners are to be exchanged
 */
export function* orientTriangles(mesh: TriangleMesh): Generator<number, Uint8Array<ArrayBuffer>, void> {
  const { canonical } = yield* asPhase(weldPositions(mesh.positions), 0, 0.1);
  const areaNormals = yield* asPhase(computeAreaNormals(mesh), 0.1, 0.15);
  const canonicalCorners = mesh.indices.map((vertex) => canonical[vertex]);
  const patches = yield* asPhase(consistentPatches(canonicalCorners, areaNormals), 0.15, 0.35);
  const { turned, patchOf } = patches;
  const parts = measureParts(mesh, areaNormals, patches);
  const needsViews = parts.some((part) => !part.isClosed || (part.volume < 0 && isNested(part, parts)));
  const votes = needsViews ? yield* asPhase(sideVotes(mesh, patches), 0.35, 1) : null;
  const facesInward = parts.map((part, i) =>
    part.isClosed ? closedFacesInward(part, parts, votes, i) : openFacesInward(votes!, i),
  );
  for (let triangle = 0; triangle < turned.length; triangle++) {
    const patch = patchOf[triangle];
    if (patch !== NO_PATCH && facesInward[patch]) turned[triangle] ^= 1;
  }
  yield 1;
  return turned;
}

/**
 * `orientTriangles` for a mesh that was not checked. Throws a RangeError for one that cannot be baked.
 *
 * @param request.label start of messages
 */
export function* orientChecked(request: {
  mesh: TriangleMesh;
  label: string;
}): Generator<number, Uint8Array<ArrayBuffer>, void> {
  yield* asPhase(validateTriangleMesh(request.mesh, request.label), 0, 0.05);
  return yield* asPhase(orientTriangles(request.mesh), 0.05, 1);
}

/** Whether an open patch is seen from its back, and clearly less from its front. */
const openFacesInward = ({ front, back }: SideVotes, patch: number): boolean =>
  back[patch] >= LEAST_VOTES && front[patch] <= LEAST_SHARE * back[patch];

/** @param votes null if no closed patch that faces inward lies within another one or around one */
function closedFacesInward(part: Part, parts: readonly Part[], votes: SideVotes | null, patch: number): boolean {
  if (part.volume >= 0) return false;
  if (!votes) return true;
  const isHidden = (i: number): boolean =>
    votes.front[i] + votes.back[i] < HIDDEN * votes.pixelsPerDoubleArea * parts[i].doubleArea;
  if (isHidden(patch) && parts.some((other) => other !== part && other.isClosed && isWithin(part, other))) return false;
  let inside = 0;
  let outwards = 0;
  for (const [i, other] of parts.entries()) {
    if (other === part || !isHidden(i) || !isWithin(other, part)) continue;
    inside += Math.abs(other.volume);
    outwards += Math.max(other.volume, 0);
  }
  return outwards <= inside / 2;
}

/** Whether a part lies within the box of another one, or another one within its box. */
const isNested = (part: Part, parts: readonly Part[]): boolean =>
  parts.some((other) => other !== part && (isWithin(part, other) || isWithin(other, part)));

/** Whether the bounding box of a part lies within that of another. */
function isWithin(inner: Part, outer: Part): boolean {
  for (let k = 0; k < 3; k++) if (inner.least[k] < outer.least[k] || inner.most[k] > outer.most[k]) return false;
  return true;
}

function measureParts(mesh: TriangleMesh, areaNormals: Float64Array, patches: Patches): Part[] {
  const { positions, indices } = mesh;
  const { patchOf, turned, isClosed, doubleAreas } = patches;
  const parts = isClosed.map(
    (isWhole, i): Part => ({
      isClosed: isWhole,
      least: [Infinity, Infinity, Infinity],
      most: [-Infinity, -Infinity, -Infinity],
      volume: 0,
      doubleArea: doubleAreas[i],
    }),
  );
  /** The first vertex of each patch, by its place in `positions`. */
  const apexes: number[] = [];
  for (let triangle = 0; triangle < patchOf.length; triangle++) {
    const patch = patchOf[triangle];
    if (patch === NO_PATCH) continue;
    const part = parts[patch];
    const corners = [0, 1, 2].map((k) => 3 * indices[3 * triangle + k]);
    for (let k = 0; k < 3; k++) {
      for (const at of corners) {
        if (positions[at + k] < part.least[k]) part.least[k] = positions[at + k];
        if (positions[at + k] > part.most[k]) part.most[k] = positions[at + k];
      }
    }
    if (!part.isClosed) continue;
    apexes[patch] ??= corners[0];
    // Measured from a vertex of the patch, since far from the origin the sum would lose its digits.
    let pyramid = 0;
    for (let k = 0; k < 3; k++)
      pyramid += (positions[corners[0] + k] - positions[apexes[patch] + k]) * areaNormals[3 * triangle + k];
    part.volume += turned[triangle] ? -pyramid : pyramid;
  }
  return parts;
}
