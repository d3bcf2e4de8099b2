import { asPhase } from '../phases.js';
import type { Simplifier } from './loadSimplifier.js';
import { sortIntoCells } from './sortIntoCells.js';

/** A mesh to simplify: its vertices stay, and fewer triangles connect some of them. */
export interface SimplifiableMesh {
  /** xyz of every vertex. */
  positions: Float32Array;
  /** Values that a simpler mesh must keep in place, `weights.length` per vertex. */
  attributes: Float32Array;
  /** For each attribute the distance, in object units, that a vertex may move for a difference of 1. */
  weights: number[];
}

/** A subset of vertices connected by fewer triangles, and its distance from the whole mesh. */
export interface Simplified {
  indices: Uint32Array<ArrayBuffer>;
  /** In object units. */
  error: number;
}

/**
 * Smallest errors that the simplifier resolves, in extents of a mesh, measured on spheres: it calculates in 32 bits from a corner of the
 * mesh.
 */
const PRECISION = 1e-3;

/** Ratio of the largest distance to the error that the simplifier reports, which is a mean over the removed triangles. */
const FARTHEST = 2.5;

/**
 * Simplifies triangles as far as the error allows, cell by cell: errors are more exact in small meshes, and a million triangles at once
 * would take a quarter of a gigabyte. Edges between two cells stay; another call with a shifted grid simplifies them.
 *
 * @param error the largest distance of the result from `indices`, in object units
 * @param shift shift of the grid in [0, 1), as a share of a cell
 * @param share the share in [0, 1] of the triangles of each cell at which simplification stops
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
 * Simplifies some triangles of a mesh; only their own vertices are passed on.
 *
 * @param numbers zeros, one per vertex of the mesh; zeros again afterwards
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
    // meshoptimizer measures lengths, and so these weights, in extents of the mesh.
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

/** The vertices of triangles in order of their first use, and the triangles in terms of these. */
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
