import { asPhase } from '../phases.js';
import type { Simplifier } from './loadSimplifier.js';
import { sortIntoCells } from './sortIntoCells.js';

/** A mesh that can be simplified: vertices stay as they are, and fewer triangles are drawn between some of them. */
export interface SimplifiableMesh {
  /** xyz of every vertex. */
  positions: Float32Array;
  /** Values that a simpler mesh shall have in the same places, `weights.length` per vertex. */
  attributes: Float32Array;
  /** How far, in object units, a vertex may move for a difference of 1 in each of them. */
  weights: number[];
}

/** Triangles of a mesh, and how far they lie from those of the whole mesh. */
export interface Simplified {
  indices: Uint32Array<ArrayBuffer>;
  /** In object units. */
  error: number;
}

/**
 * The errors that count in a mesh, in its extents: the simplifier calculates with numbers of 32 bits from a corner of the mesh, so that in a
 * mesh that is larger it allows more than it says. This was measured on spheres.
 */
const PRECISION = 1e-3;

/** How much farther a place may lie than the simplifier says, which measures a mean over what it has taken away. */
const FARTHEST = 2.5;

/**
 * Simplifies triangles as far as the error allows, cell by cell, since errors are known the better the smaller a mesh is, and a million
 * triangles at once would take a quarter of a gigabyte. Where two cells meet, edges stay as they are: another call with a shifted grid
 * simplifies them there.
 *
 * @param error how far the result may lie from `indices`, in object units
 * @param shift by which share of a cell the grid is shifted, in [0, 1)
 * @param share in [0, 1] of the triangles of each cell that is enough: no more are taken away, whatever the error allows
 */
export function* simplifyTriangles(
  mesh: SimplifiableMesh,
  indices: Uint32Array<ArrayBuffer>,
  error: number,
  simplifier: Simplifier,
  shift = 0,
  share = 0,
): Generator<number, Simplified, void> {
  const allowed = error / FARTHEST;
  const cellSize = allowed / PRECISION;
  const { indices: sorted, starts } = yield* asPhase(sortIntoCells(mesh.positions, indices, cellSize, shift), 0, 0.1);
  const filled = [...starts].filter((start, i) => i + 1 < starts.length && starts[i + 1] > start);
  const numbers = new Uint32Array(mesh.positions.length / 3);
  const parts: Uint32Array[] = [];
  let farthest = 0;
  for (const [i, start] of filled.entries()) {
    const end = filled[i + 1] ?? sorted.length;
    const part = simplifyPart(
      mesh,
      sorted.subarray(start, end),
      numbers,
      { allowed, share, keepsBorder: filled.length > 1 },
      simplifier,
    );
    parts.push(part.indices);
    farthest = Math.max(farthest, part.error);
    yield 0.1 + (0.9 * end) / sorted.length;
  }
  const all = new Uint32Array(parts.reduce((sum, { length }) => sum + length, 0));
  let end = 0;
  for (const part of parts) {
    all.set(part, end);
    end += part.length;
  }
  return { indices: all, error: FARTHEST * farthest };
}

/**
 * Simplifies some triangles of a mesh, of which only their own vertices are handed over.
 *
 * @param numbers one per vertex of the mesh, all 0, as they are again afterwards
 */
function simplifyPart(
  { positions, attributes, weights }: SimplifiableMesh,
  indices: Uint32Array,
  numbers: Uint32Array,
  { allowed, share, keepsBorder }: { allowed: number; share: number; keepsBorder: boolean },
  simplifier: Simplifier,
): Simplified {
  const own = ownVertices(indices, numbers);
  const count = own.vertices.length;
  const stride = weights.length;
  const ownPositions = new Float32Array(3 * count);
  const ownAttributes = new Float32Array(stride * count);
  for (let i = 0; i < count; i++) {
    const from = own.vertices[i];
    for (let k = 0; k < 3; k++) ownPositions[3 * i + k] = positions[3 * from + k];
    for (let k = 0; k < stride; k++) ownAttributes[stride * i + k] = attributes[stride * from + k];
  }
  const extent = extentOf(ownPositions);
  const [result, farthest] = simplifier.simplifyWithAttributes(
    own.indices,
    ownPositions,
    3,
    ownAttributes,
    stride,
    // The library measures lengths in extents of the mesh, and these weights with them.
    weights.map((weight) => weight / (extent || 1)),
    null,
    3 * Math.floor((share * indices.length) / 3),
    allowed,
    ['ErrorAbsolute', 'Permissive', ...(keepsBorder ? (['LockBorder'] as const) : [])],
  );
  const simplified = new Uint32Array(result.length);
  for (let i = 0; i < result.length; i++) simplified[i] = own.vertices[result[i]];
  return { indices: simplified, error: farthest };
}

/** The vertices of triangles in the order in which they are met, and the triangles by these. */
function ownVertices(indices: Uint32Array, numbers: Uint32Array): { vertices: Uint32Array; indices: Uint32Array } {
  const vertices = new Uint32Array(indices.length);
  const own = new Uint32Array(indices.length);
  let count = 0;
  for (let i = 0; i < indices.length; i++) {
    const vertex = indices[i];
    if (numbers[vertex] === 0) {
      vertices[count++] = vertex;
      numbers[vertex] = count;
    }
    own[i] = numbers[vertex] - 1;
  }
  for (let i = 0; i < count; i++) numbers[vertices[i]] = 0;
  return { vertices: vertices.subarray(0, count), indices: own };
}

/** The longest side of the box around points. */
function extentOf(positions: Float32Array): number {
  let extent = 0;
  for (let axis = 0; axis < 3; axis++) {
    let min = Infinity;
    let max = -Infinity;
    for (let i = axis; i < positions.length; i += 3) {
      if (positions[i] < min) min = positions[i];
      if (positions[i] > max) max = positions[i];
    }
    extent = Math.max(extent, max - min);
  }
  return extent;
}
