import { computeAreaNormals } from '../computeAreaNormals.js';
import { asPhase } from '../phases.js';
import { type TriangleMesh, validateTriangleMesh } from '../TriangleMesh.js';
import { weldPositions } from '../weldPositions.js';
import { consistentPatches, NO_PATCH, type Patches } from './consistentPatches.js';
import { Enclosures } from './Enclosures.js';
import { measureParts, type Part } from './measureParts.js';
import { bodiesOf, edgeSums } from './openTriangles.js';
import { isWithin, partsWithin } from './partsWithin.js';
import { sideVotes } from './sideVotes.js';

/** How much less an open patch must be seen from one side than from the other for its side to be clear. Others are seen from both. */
const LEAST_SHARE = 0.56;
/** The fewest votes that tell the side of a patch. */
const LEAST_VOTES = 4;
/** Patches with borders or pinched edges are left if their share of the area in all is less: scans have fragments that face any way. */
const FRAGMENTS = 0.002;
/** A closed patch of a lesser volume, as a share of the power 3/2 of its area, is a sheet that lies on itself. */
const FLAT = 1e-6;
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
  const { turned, patchOf, isClosed } = patches;
  // More than two triangles may share an edge of a closed patch.
  const edges = yield* asPhase(edgeSums(mesh, canonical, patchOf, isClosed.length), 0.35, 0.4);
  const isPinched = isClosed.map((isWhole, patch) => !isWhole && edges[patch] === 0);
  for (const patch of isPinched.keys()) isClosed[patch] ||= isPinched[patch];
  const parts = measureParts(mesh, areaNormals, patches);
  const around = enclosingParts(mesh, patches);
  const within = partsWithin(parts);
  const isTurned = yield* closedInward(parts, around, within);
  leaveFragments(parts, isTurned, isPinched);
  if (parts.some(({ isClosed }) => !isClosed)) {
    const votes = yield* asPhase(sideVotes(mesh, patches, parts), 0.4, 0.9);
    const open = [...parts.keys()].filter((i) => !parts[i].isClosed);
    const inward = open.filter((i) => isClear(votes.back[i], votes.front[i]));
    for (const i of inward) isTurned[i] = true;
    leaveFragments(
      parts,
      isTurned,
      parts.map(({ isClosed }) => !isClosed),
    );
    for (const i of inward) {
      if (isRoom(parts, i, isTurned, around, within)) isTurned[i] = false;
      yield 0.9;
    }
    if (isTurned.includes(true)) {
      const isRight = parts.map((_, i) => !isTurned[i] && isClear(votes.front[i], votes.back[i]));
      const bodyOf = yield* bodiesOf(mesh, canonical);
      turnTogether(bodyOf, edges, patches, parts, isTurned, isRight);
    }
  }
  for (let triangle = 0; triangle < turned.length; triangle++) {
    const patch = patchOf[triangle];
    if (patch !== NO_PATCH && isTurned[patch]) turned[triangle] ^= 1;
  }
  yield 1;
  return turned;
}

/** What is known of the patches of a body that are open by themselves. */
interface OpenPatches {
  patches: number[];
  /** The sum of the hashes of their edges: 0 if they close each other. */
  edges: number;
  /** The area of what is to be turned, less that of what is right. */
  balance: number;
}

/**
 * Turns the open patches of a body together if they close each other, as most of them need, by area: one alone would leave a gap.
 *
 * @param edges see `edgeSums`, of the patches
 */
function turnTogether(
  bodyOf: Uint32Array,
  edges: Int32Array,
  { patchOf }: Patches,
  parts: readonly Part[],
  isTurned: boolean[],
  isRight: readonly boolean[],
): void {
  const bodies = new Map<number, OpenPatches>();
  const isKnown = new Uint8Array(parts.length);
  for (let triangle = 0; triangle < patchOf.length; triangle++) {
    const patch = patchOf[triangle];
    if (patch === NO_PATCH || isKnown[patch] || parts[patch].isClosed) continue;
    isKnown[patch] = 1;
    const known = bodies.get(bodyOf[triangle]) ?? { patches: [], edges: 0, balance: 0 };
    bodies.set(bodyOf[triangle], known);
    known.patches.push(patch);
    known.edges = (known.edges + edges[patch]) | 0;
    if (isTurned[patch] || isRight[patch]) known.balance += (isTurned[patch] ? 1 : -1) * parts[patch].doubleArea;
  }
  for (const { patches, edges, balance } of bodies.values())
    if (edges === 0) for (const patch of patches) isTurned[patch] = balance > 0;
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

/** Leaves some of the patches as they are if those that would be turned are no more than fragments. */
function leaveFragments(parts: readonly Part[], isTurned: boolean[], among: readonly boolean[]): void {
  const turned = [...parts.keys()].filter((i) => among[i] && isTurned[i]);
  if (areaOf(turned.map((i) => parts[i])) >= FRAGMENTS * areaOf(parts)) return;
  for (const i of turned) isTurned[i] = false;
}

const areaOf = (parts: readonly Part[]): number => parts.reduce((sum, { doubleArea }) => sum + doubleArea, 0);

/** Whether a patch is seen from one side, and clearly less from the other. */
const isClear = (votes: number, others: number): boolean => votes >= LEAST_VOTES && others <= LEAST_SHARE * votes;

/** The patches that enclose a part. */
type Around = (part: Part) => Set<number>;
/** The parts whose bounding boxes lie within that of a part. */
type Within = (outer: number) => number[];

/** For each part whether it is closed and faces inward without reason. */
function* closedInward(parts: readonly Part[], around: Around, within: Within): Generator<number, boolean[], void> {
  const isInward = parts.map(({ volume, doubleArea }) => volume < -FLAT * doubleArea ** 1.5);
  const isTurned = [...isInward];
  const inward = [...parts.keys()].filter((i) => isInward[i]);
  if (inward.length * parts.length > MOST_COMPARISONS) return isTurned;
  // From the outermost on, since it matters whether what is around a part was inside out itself.
  for (const i of inward.sort((a, b) => parts[a].volume - parts[b].volume)) {
    const isInside = parts.some(
      (other, k) => k !== i && other.isClosed && !isTurned[k] && isWithin(parts[i], other) && around(parts[i]).has(k),
    );
    isTurned[i] = !isInside && !isRoom(parts, i, isInward, around, within);
    yield 0.4;
  }
  return isTurned;
}

/** Whether enough lies inside a part that does not face inward as it does. */
function isRoom(
  parts: readonly Part[],
  room: number,
  isInward: readonly boolean[],
  around: Around,
  within: Within,
): boolean {
  const needed = CONTENTS * parts[room].doubleArea;
  const boxed = within(room);
  // What is not even in its bounding box is not in it.
  if (areaOf(boxed.filter((i) => !isInward[i]).map((i) => parts[i])) <= needed) return false;
  let inward = 0;
  let others = 0;
  for (const i of boxed) {
    if (!around(parts[i]).has(room)) continue;
    if (isInward[i]) inward += parts[i].doubleArea;
    else others += parts[i].doubleArea;
  }
  return others > inward && others > needed;
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
