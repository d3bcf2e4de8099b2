import { computeAreaNormals } from '../computeAreaNormals.js';
import { asPhase } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { weldPositions } from '../weldPositions.js';
import { consistentPatches, NO_PATCH, type Patches } from './consistentPatches.js';
import { type SideVotes, sideVotes } from './sideVotes.js';

/** How much less a patch must be seen from its front than from its back for it to be turned. Others count as seen from both sides. */
const LEAST_SHARE = 0.56;
/** The fewest pixels, over all directions, that tell the side of a patch. */
const LEAST_VOTES = 4;
/** Rays that decide whether a point is inside a closed patch: the majority of them counts. Oblique, so that they rarely meet edges. */
const RAYS = [
  [0.5377, 0.7043, 0.4635],
  [-0.3313, 0.5023, 0.7987],
  [0.7253, -0.4129, 0.5509],
] as const;

/** A patch with what decides which way it faces. */
interface Part {
  /** Its triangles. */
  triangles: Uint32Array;
  least: number[];
  most: number[];
  /** A point of its surface. */
  point: number[];
  /** Six times the volume that a closed patch encloses, negative if it faces inward; of an open one 0. */
  volume: number;
}

/**
 * Finds the triangles that face the wrong way, in a mesh from a file that promises nothing: patches whose windings contradict each other,
 * closed patches that face inward, and open ones that are seen from their back. Nothing is turned that is right:
 *
 * - a closed patch inside another one is left as most of it is: it may be the wall of a cavity;
 * - a closed patch around others, such as a room with its furniture, is left unless they face inward too;
 * - an open patch that is seen about as much from both sides is left as most of it is.
 *
 * @returns for each triangle 1 if two of its corners are to be exchanged
 */
export function* orientTriangles(mesh: TriangleMesh): Generator<number, Uint8Array, void> {
  const { canonical } = yield* asPhase(weldPositions(mesh.positions), 0, 0.1);
  const areaNormals = yield* asPhase(computeAreaNormals(mesh), 0.1, 0.15);
  const canonicalCorners = mesh.indices.map((vertex) => canonical[vertex]);
  const patches = yield* asPhase(consistentPatches(canonicalCorners, areaNormals), 0.15, 0.35);
  const { turned, patchOf, isClosed } = patches;
  const parts = measureParts(mesh, areaNormals, patches);
  const votes = isClosed.every(Boolean) ? null : yield* asPhase(sideVotes(mesh, patches), 0.35, 1);
  const facesInward = parts.map((part, i) =>
    isClosed[i] ? closedFacesInward(mesh, part, parts, isClosed) : openFacesInward(votes!, i),
  );
  for (let triangle = 0; triangle < turned.length; triangle++) {
    const patch = patchOf[triangle];
    if (patch !== NO_PATCH && facesInward[patch]) turned[triangle] ^= 1;
  }
  yield 1;
  return turned;
}

/** Whether an open patch is seen from its back, and clearly less from its front. */
const openFacesInward = ({ front, back }: SideVotes, patch: number): boolean =>
  back[patch] >= LEAST_VOTES && front[patch] <= LEAST_SHARE * back[patch];

function closedFacesInward(
  mesh: TriangleMesh,
  part: Part,
  parts: readonly Part[],
  isClosed: readonly boolean[],
): boolean {
  if (part.volume >= 0) return false;
  let inside = 0;
  let outwards = 0;
  for (const [i, other] of parts.entries()) {
    if (other === part) continue;
    if (isClosed[i] && isWithin(part, other) && encloses(mesh, other, part.point)) return false;
    if (isWithin(other, part) && encloses(mesh, part, other.point)) {
      inside += Math.abs(other.volume);
      outwards += Math.max(other.volume, 0);
    }
  }
  return outwards <= inside / 2;
}

/** Whether the bounding box of a part lies within that of another. */
const isWithin = (inner: Part, outer: Part): boolean =>
  inner.least.every((x, k) => x >= outer.least[k]) && inner.most.every((x, k) => x <= outer.most[k]);

/** Whether most rays from a point cross the surface of a closed part an odd number of times. */
function encloses({ positions, indices }: TriangleMesh, { triangles }: Part, point: readonly number[]): boolean {
  let odd = 0;
  for (const ray of RAYS) {
    let crossings = 0;
    for (const triangle of triangles) {
      const corner = 3 * triangle;
      if (crosses(positions, 3 * indices[corner], 3 * indices[corner + 1], 3 * indices[corner + 2], point, ray))
        crossings++;
    }
    odd += crossings % 2;
  }
  return 2 * odd > RAYS.length;
}

/** Whether a ray meets a triangle (Möller and Trumbore, 1997). */
function crosses(
  positions: Float32Array,
  a: number,
  b: number,
  c: number,
  [ox, oy, oz]: readonly number[],
  [dx, dy, dz]: readonly number[],
): boolean {
  const ux = positions[b] - positions[a];
  const uy = positions[b + 1] - positions[a + 1];
  const uz = positions[b + 2] - positions[a + 2];
  const vx = positions[c] - positions[a];
  const vy = positions[c + 1] - positions[a + 1];
  const vz = positions[c + 2] - positions[a + 2];
  const px = dy * vz - dz * vy;
  const py = dz * vx - dx * vz;
  const pz = dx * vy - dy * vx;
  const determinant = ux * px + uy * py + uz * pz;
  if (determinant === 0) return false;
  const tx = ox - positions[a];
  const ty = oy - positions[a + 1];
  const tz = oz - positions[a + 2];
  const shareU = (tx * px + ty * py + tz * pz) / determinant;
  if (shareU < 0 || shareU > 1) return false;
  const qx = ty * uz - tz * uy;
  const qy = tz * ux - tx * uz;
  const qz = tx * uy - ty * ux;
  const shareV = (dx * qx + dy * qy + dz * qz) / determinant;
  if (shareV < 0 || shareU + shareV > 1) return false;
  return (vx * qx + vy * qy + vz * qz) / determinant > 0;
}

function measureParts(mesh: TriangleMesh, areaNormals: Float64Array, patches: Patches): Part[] {
  const { positions, indices } = mesh;
  const { patchOf, turned, isClosed } = patches;
  const counts = new Uint32Array(isClosed.length);
  for (const patch of patchOf) if (patch !== NO_PATCH) counts[patch]++;
  const parts = Array.from(
    counts,
    (count): Part => ({
      triangles: new Uint32Array(count),
      least: [Infinity, Infinity, Infinity],
      most: [-Infinity, -Infinity, -Infinity],
      point: [],
      volume: 0,
    }),
  );
  const filled = new Uint32Array(isClosed.length);
  for (let triangle = 0; triangle < patchOf.length; triangle++) {
    const patch = patchOf[triangle];
    if (patch === NO_PATCH) continue;
    const part = parts[patch];
    part.triangles[filled[patch]++] = triangle;
    const corners = [0, 1, 2].map((k) => 3 * indices[3 * triangle + k]);
    if (part.point.length === 0) {
      part.point = [0, 1, 2].map((k) => corners.reduce((sum, at) => sum + positions[at + k] / 3, 0));
    }
    for (let k = 0; k < 3; k++) {
      for (const at of corners) {
        if (positions[at + k] < part.least[k]) part.least[k] = positions[at + k];
        if (positions[at + k] > part.most[k]) part.most[k] = positions[at + k];
      }
    }
    if (!isClosed[patch]) continue;
    // Measured from a point of the patch, since far from the origin the sum would lose its digits.
    let pyramid = 0;
    for (let k = 0; k < 3; k++) pyramid += (positions[corners[0] + k] - part.point[k]) * areaNormals[3 * triangle + k];
    part.volume += turned[triangle] ? -pyramid : pyramid;
  }
  return parts;
}
