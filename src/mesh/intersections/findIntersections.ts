import { asPhase } from '../phases.js';
import { crossMeshes, type Work } from './crossMeshes.js';
import { joinSegments } from './joinSegments.js';
import { boxOf, type Grid, gridOver, type IntersectingMesh, MeetingMesh } from './MeetingMesh.js';
import { MOST_TRIANGLES, pairsOf } from './pairsOf.js';

/** What `findIntersections` is asked for. Plain data. */
export interface IntersectionRequest {
  meshes: IntersectingMesh[];
  /**
   * The meshes of each pair that is looked at, two numbers each; a mesh twice for the lines between its shells. Default: all pairs whose
   * boxes meet, and all shells.
   */
  pairs?: readonly number[] | undefined;
}

/** The lines of a pair of meshes. */
export interface MeetingLines {
  /** The number of the pair among those that were asked for. */
  pair: number;
  first: number;
  second: number;
  /** `LINE_FLOATS` numbers per segment, in the shared space; null if it was too much work. */
  lines: Float64Array<ArrayBuffer> | null;
}

/** Most work, as `crossMeshes` counts it: some two seconds. */
const MOST_WORK = 2 ** 25;
/** Finds the lines along which the surfaces of meshes cut each other, and those of the shells of each mesh. Yields its progress. */
export function* findIntersections({ meshes, pairs }: IntersectionRequest): Generator<number, MeetingLines[], void> {
  const boxes = meshes.map((mesh) => (mesh.triangles.length <= 3 * MOST_TRIANGLES ? boxOf(mesh) : null));
  yield 0.05;
  const known = boxes.filter((box) => box !== null);
  const grid = gridOver(known);
  const asked = pairs ? pairsIn(pairs) : pairsOf(boxes);
  const prepared = new Map<number, MeetingMesh>();
  const found: MeetingLines[] = [];
  const work = { left: MOST_WORK };
  for (const [i, [first, second]] of asked.entries()) {
    const [from, to] = [0.05 + (0.95 * i) / asked.length, 0.05 + (0.95 * (i + 1)) / asked.length];
    yield from;
    if (boxes[first] === null || boxes[second] === null) continue;
    if (work.left < 0) {
      found.push({ pair: i, first, second, lines: null });
      continue;
    }
    for (const number of [first, second])
      if (!prepared.has(number))
        prepared.set(number, yield* asPhase(MeetingMesh.of(meshes[number], grid), from, (from + to) / 2));
    const [a, b] = [prepared.get(first)!, prepared.get(second)!];
    const lines = yield* asPhase(linesOf(a, b, grid, work), (from + to) / 2, to);
    if (lines === null || lines.length > 0) found.push({ pair: i, first, second, lines });
  }
  return found;
}

function* linesOf(
  first: MeetingMesh,
  second: MeetingMesh,
  grid: Grid,
  work: Work,
): Generator<number, Float64Array<ArrayBuffer> | null, void> {
  const crossings = yield* crossMeshes(first, second, work);
  if (crossings === null) return null;
  return yield* joinSegments(crossings, first, second, Math.min(diagonalOf(first), diagonalOf(second)), grid);
}

/** The diagonal of the box of a mesh, in steps of the grid. */
const diagonalOf = ({ tree: { boxes } }: MeetingMesh): number =>
  Math.hypot(boxes[3] - boxes[0], boxes[4] - boxes[1], boxes[5] - boxes[2]);

function pairsIn(numbers: readonly number[]): (readonly [number, number])[] {
  return Array.from({ length: numbers.length >> 1 }, (_, i) => [numbers[2 * i], numbers[2 * i + 1]]);
}
