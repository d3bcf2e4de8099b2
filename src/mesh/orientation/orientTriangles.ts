import { computeAreaNormals, doubleArea } from '../computeAreaNormals.js';
import { asPhase } from '../phases.js';
import { type TriangleMesh, validateTriangleMesh } from '../TriangleMesh.js';
import { weldPositions } from '../weldPositions.js';
import { consistentPatches, NO_PATCH, type Patches } from './consistentPatches.js';
import { Enclosures } from './Enclosures.js';
import { measureParts, type Part } from './measureParts.js';
import { type Bodies, measureBodies } from './openTriangles.js';
import { type SideVotes, sideVotes } from './sideVotes.js';

/** How much less an open patch must be seen from its front than from its back for it to be turned. Others are seen from both sides. */
const LEAST_SHARE = 0.56;
/** The fewest votes that tell the side of a patch. */
const LEAST_VOTES = 4;
/** Open patches of a lesser share of the area in all are left: scans have fragments that face any way. */
const FRAGMENTS = 0.002;
/** What is inside a patch counts if it has at least this share of its area. */
const CONTENTS = 0.03;
/** Samples of a part are moved towards its middle by this share, since parts that touch lie inside one another, too. */
const SHRINK = 0.02;
/** More comparisons of parts would take too long; the parts then count as separate. */
const MOST_COMPARISONS = 5e7;

/**
 * Finds the triangles that face the wrong way, in a mesh from a file that promises nothing: patches whose windings contradict each other,
 * closed patches that face inward, and open ones that are seen from their back. Nothing is turned that may be right:
 *
 * - a closed patch inside another one is left as most of it is: it may be the wall of a cavity;
 * - a patch around others, such as a room with its furniture, is left unless they face inward, too;
 * - an open patch that is seen about as much from both sides, or not at all, is left as most of it is;
 * - open patches that close each other, where more than two triangles share an edge, are turned together or not at all.
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
  const around = enclosingParts(mesh, patches);
  const isTurned = closedInward(parts, around);
  if (parts.some(({ isClosed }) => !isClosed)) {
    const votes = yield* asPhase(sideVotes(mesh, patches, parts), 0.4, 1);
    const inward = [...parts.keys()].filter((i) => !parts[i].isClosed && openFacesInward(votes, i));
    const isNoise = areaOf(inward.map((i) => parts[i])) < FRAGMENTS * areaOf(parts);
    for (const i of inward) isTurned[i] = !isNoise;
    for (const i of inward) if (isRoom(parts, i, isTurned, around)) isTurned[i] = false;
  }
  for (let triangle = 0; triangle < turned.length; triangle++) {
    const patch = patchOf[triangle];
    if (patch !== NO_PATCH && isTurned[patch]) turned[triangle] ^= 1;
  }
  if (turned.includes(1) && parts.some(({ isClosed }) => !isClosed)) {
    const bodies = yield* measureBodies(mesh, canonical);
    const isOpen = (triangle: number): boolean => patchOf[triangle] !== NO_PATCH && !parts[patchOf[triangle]].isClosed;
    turnTogether(bodies, areaNormals, isOpen, turned);
  }
  yield 1;
  return turned;
}

/** Turns the open patches of each closed body as most of their area is turned, since one alone would leave a gap. */
function turnTogether(
  { ofTriangles, edges }: Bodies,
  areaNormals: Float64Array,
  isOpen: (triangle: number) => boolean,
  turned: Uint8Array,
): void {
  /** Of each closed body the area of what is turned, less that of the rest. */
  const balance = new Map<number, number>();
  for (let triangle = 0; triangle < turned.length; triangle++) {
    const body = ofTriangles[triangle];
    if (edges[body] !== 0 || !isOpen(triangle)) continue;
    const area = doubleArea(areaNormals, triangle);
    balance.set(body, (balance.get(body) ?? 0) + (turned[triangle] ? area : -area));
  }
  for (let triangle = 0; triangle < turned.length; triangle++) {
    const sum = balance.get(ofTriangles[triangle]);
    if (sum !== undefined && isOpen(triangle)) turned[triangle] = sum > 0 ? 1 : 0;
  }
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

const areaOf = (parts: readonly Part[]): number => parts.reduce((sum, { doubleArea }) => sum + doubleArea, 0);

/** Whether an open patch is seen from its back, and clearly less from its front. */
const openFacesInward = ({ front, back }: SideVotes, patch: number): boolean =>
  back[patch] >= LEAST_VOTES && front[patch] <= LEAST_SHARE * back[patch];

/** The patches that enclose a part. */
type Around = (part: Part) => Set<number>;

/** For each part whether it is closed and faces inward without reason. */
function closedInward(parts: readonly Part[], around: Around): boolean[] {
  const isInward = parts.map(({ volume }) => volume < 0);
  const isTurned = [...isInward];
  const inward = [...parts.keys()].filter((i) => isInward[i]);
  if (inward.length * parts.length > MOST_COMPARISONS) return isTurned;
  // From the outermost on, since it matters whether what is around a part was inside out itself.
  for (const i of inward.sort((a, b) => parts[a].volume - parts[b].volume)) {
    const isInside = parts.some(
      (other, k) => k !== i && other.isClosed && !isTurned[k] && isWithin(parts[i], other) && around(parts[i]).has(k),
    );
    isTurned[i] = !isInside && !isRoom(parts, i, isInward, around);
  }
  return isTurned;
}

/** Whether enough lies inside a part that does not face inward as it does. */
function isRoom(parts: readonly Part[], room: number, isInward: readonly boolean[], around: Around): boolean {
  let inward = 0;
  let others = 0;
  for (const [i, part] of parts.entries()) {
    if (i === room || !isWithin(part, parts[room]) || !around(part).has(room)) continue;
    if (isInward[i]) inward += part.doubleArea;
    else others += part.doubleArea;
  }
  return others > inward && others > CONTENTS * parts[room].doubleArea;
}

/** Returns a function for the patches that enclose a part, which finds them on demand. */
function enclosingParts(mesh: TriangleMesh, patches: Patches): Around {
  let enclosures: Enclosures | undefined;
  const known = new Map<Part, Set<number>>();
  return (part) => {
    const found = known.get(part);
    if (found) return found;
    enclosures ??= new Enclosures(mesh, patches);
    const made = enclosing(part, mesh, enclosures);
    known.set(part, made);
    return made;
  };
}

/** The patches that enclose all samples of a part. */
function enclosing(
  { least, most, samples }: Part,
  { positions, indices }: TriangleMesh,
  enclosures: Enclosures,
): Set<number> {
  let found: Set<number> | undefined;
  for (const triangle of samples) {
    const at = 3 * indices[3 * triangle];
    const [x, y, z] = [0, 1, 2].map(
      (k) => positions[at + k] + SHRINK * (0.5 * (least[k] + most[k]) - positions[at + k]),
    );
    const here = enclosures.around([x, y, z]);
    found = found ? new Set([...found].filter((patch) => here.has(patch))) : here;
    if (found.size === 0) break;
  }
  return found ?? new Set();
}

/** Whether the bounding box of a part lies within that of another. */
function isWithin(inner: Part, outer: Part): boolean {
  for (let k = 0; k < 3; k++) if (inner.least[k] < outer.least[k] || inner.most[k] > outer.most[k]) return false;
  return true;
}
