import { chunkPhase } from '../phases.js';

/** The data of a search for contours. Plain data: it is posted to the worker and back. */
export interface ContourSearch {
  /** x, y, z of each point. */
  positions: Float32Array<ArrayBuffer>;
  /** x, y, z of each point's unit normal. */
  normals: Float32Array<ArrayBuffer>;
  /** Four words per primitive (`outlineLayout.ts` of the bake): numbers of points, with flags in the bits above `pointMask`. */
  primitives: Uint32Array<ArrayBuffer>;
  pointMask: number;
  /** The number of bits in the mask. */
  pointBits: number;
  triangleCount: number;
  edgeCount: number;
  /** Scratch memory, a value per point: 1 certainly faces the eye, 2 certainly faces away, 3 is uncertain. */
  sides: Uint8Array<ArrayBuffer>;
  /** The numbers of the candidates, with room for every primitive. */
  list: Uint32Array<ArrayBuffer>;
}

/** The eye in object space: x, y, z and 1, or, for an orthographic camera, the unit direction towards it and 0. */
export type Eye = readonly [number, number, number, number];

const FACES = 1;
const LOOKS_AWAY = 2;

/**
 * Lists the candidates: the primitives that may hold a line as long as the direction to the eye turns by less than an angle. A
 * triangle is left out if its three corners all face the eye, or all face away, by more than that angle. Borders and creases are
 * candidates, since the back of the surface may be visible; other edges follow the rule for triangles. Fills `list`, with triangles
 * before edges, and returns the number of candidates.
 *
 * @param sine the sine of the angle
 */
export function* contourCandidates(search: ContourSearch, eye: Eye, sine: number): Generator<number, number, void> {
  const { triangleCount, edgeCount } = search;
  const points = search.positions.length / 3;
  yield* chunkPhase(points, 0, 0.6, (start, end) => judgePoints(search, eye, sine, start, end));
  let count = 0;
  yield* chunkPhase(triangleCount, 0.6, 0.95, (start, end) => {
    count = listTriangles(search, count, start, end);
  });
  yield* chunkPhase(edgeCount, 0.95, 1, (start, end) => {
    count = listEdges(search, count, start, end);
  });
  return count;
}

/** Runs `contourCandidates` without yielding. */
export function findCandidates(search: ContourSearch, eye: Eye, sine: number): number {
  const { triangleCount, edgeCount } = search;
  judgePoints(search, eye, sine, 0, search.positions.length / 3);
  return listEdges(search, listTriangles(search, 0, 0, triangleCount), 0, edgeCount);
}

function judgePoints({ positions, normals, sides }: ContourSearch, eye: Eye, sine: number, start: number, end: number) {
  const [eyeX, eyeY, eyeZ, isPlace] = eye;
  const squaredSine = sine * sine;
  for (let point = start; point < end; point++) {
    const i = 3 * point;
    const x = eyeX - isPlace * positions[i];
    const y = eyeY - isPlace * positions[i + 1];
    const z = eyeZ - isPlace * positions[i + 2];
    const facing = normals[i] * x + normals[i + 1] * y + normals[i + 2] * z;
    const isSure = facing * facing > squaredSine * (x * x + y * y + z * z);
    sides[point] = isSure ? (facing > 0 ? FACES : LOOKS_AWAY) : FACES | LOOKS_AWAY;
  }
}

function listTriangles(
  { primitives, sides, list, pointMask }: ContourSearch,
  listed: number,
  start: number,
  end: number,
): number {
  let count = listed;
  for (let triangle = start; triangle < end; triangle++) {
    const i = 4 * triangle;
    const both = sides[primitives[i]] | sides[primitives[i + 1]] | sides[primitives[i + 2] & pointMask];
    if (both === (FACES | LOOKS_AWAY)) list[count++] = triangle;
  }
  return count;
}

function listEdges(
  { primitives, sides, list, pointMask, pointBits, triangleCount }: ContourSearch,
  listed: number,
  start: number,
  end: number,
): number {
  let count = listed;
  for (let edge = triangleCount + start; edge < triangleCount + end; edge++) {
    const i = 4 * edge;
    const first = primitives[i];
    const leftSides = sides[first & pointMask] | sides[primitives[i + 1] & pointMask];
    const rightSides = sides[primitives[i + 2] & pointMask] | sides[primitives[i + 3] & pointMask];
    const both = leftSides | rightSides;
    // An edge without a mark can only hold the contour, which needs a side that faces the eye and one that faces away.
    const kinds = (first & ~pointMask) >>> pointBits;
    const isSeen = kinds !== 0 || both === (FACES | LOOKS_AWAY);
    if (isSeen) list[count++] = edge;
  }
  return count;
}

/** The input of `searchContours`. Plain data: it is posted to the worker. */
export interface ContourSearchRequest {
  search: ContourSearch;
  eye: Eye;
  sine: number;
}

/** The result of `searchContours`: the arrays of the search, and the number of candidates in `list`. */
export interface ContourSearchResult {
  search: ContourSearch;
  count: number;
}

/** Runs `contourCandidates` as a task of the worker. */
export function* searchContours({
  search,
  eye,
  sine,
}: ContourSearchRequest): Generator<number, ContourSearchResult, void> {
  return { search, count: yield* contourCandidates(search, eye, sine) };
}
