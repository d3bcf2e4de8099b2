import { asPhase, chunkPhase } from '../phases.js';
import type { Simplifier } from './loadSimplifier.js';

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
interface Simplified {
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

/** Largest number of cells along an axis. */
const MOST_ALONG = 64;

/** Triangles in the order of their cubic cells. */
interface SortedTriangles {
  /** The corners of all triangles, cell by cell. */
  indices: Uint32Array<ArrayBuffer>;
  /** The start of each cell in `indices`, then the end of the last one. Cells may be empty. */
  starts: Uint32Array;
}

/** A grid of cells over a box. */
interface Grid {
  min: number[];
  /** Cells per unit. */
  scale: number;
  along: number[];
}

/**
 * Sorts triangles into cubic cells by their centres, so that each cell can be simplified alone: triangles near each other in space may be
 * far apart in a file.
 *
 * @param size of a cell, in object units; larger where there would be more than 64 along an axis
 * @param shift shift of the grid in [0, 1), as a share of a cell
 */
function* sortIntoCells(
  positions: Float32Array,
  indices: Uint32Array,
  size: number,
  shift: number,
): Generator<number, SortedTriangles, void> {
  const count = indices.length / 3;
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  yield* chunkPhase(positions.length / 3, 0, 0.2, (start, end) => widen(min, max, positions, start, end));
  const grid = gridOver(min, max, size, shift);
  const cells = new Uint32Array(count);
  const places = new Uint32Array(grid.along[0] * grid.along[1] * grid.along[2] + 1);
  yield* chunkPhase(count, 0.2, 0.6, (start, end) => findCells(cells, places, positions, indices, grid, start, end));
  let total = 0;
  for (let cell = 0; cell < places.length; cell++) {
    const inCell = places[cell];
    places[cell] = total;
    total += inCell;
  }
  const starts = places.map((place) => 3 * place);
  const sorted = new Uint32Array(indices.length);
  yield* chunkPhase(count, 0.6, 1, (start, end) => place(sorted, places, cells, indices, start, end));
  return { indices: sorted, starts };
}

function gridOver(min: readonly number[], max: readonly number[], size: number, shift: number): Grid {
  const extent = Math.max(...max.map((value, axis) => value - min[axis]), 0);
  const edge = Math.max(size, extent / (MOST_ALONG - 1)) || 1;
  return {
    min: min.map((value) => value - shift * edge),
    scale: 1 / edge,
    along: max.map((value, axis) => Math.floor((value - min[axis]) / edge + shift) + 1),
  };
}

function widen(min: number[], max: number[], positions: Float32Array, start: number, end: number): void {
  for (let i = 3 * start; i < 3 * end; i++) {
    const axis = i % 3;
    const value = positions[i];
    if (value < min[axis]) min[axis] = value;
    if (value > max[axis]) max[axis] = value;
  }
}

function findCells(
  cells: Uint32Array,
  sizes: Uint32Array,
  positions: Float32Array,
  indices: Uint32Array,
  { min, scale, along }: Grid,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const [a, b, c] = [3 * indices[3 * i], 3 * indices[3 * i + 1], 3 * indices[3 * i + 2]];
    let cell = 0;
    for (let axis = 2; axis >= 0; axis--) {
      const centre = (positions[a + axis] + positions[b + axis] + positions[c + axis]) / 3;
      const place = Math.floor((centre - min[axis]) * scale);
      cell = cell * along[axis] + Math.min(along[axis] - 1, Math.max(0, place));
    }
    cells[i] = cell;
    sizes[cell]++;
  }
}

function place(
  sorted: Uint32Array,
  places: Uint32Array,
  cells: Uint32Array,
  indices: Uint32Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const to = 3 * places[cells[i]]++;
    sorted[to] = indices[3 * i];
    sorted[to + 1] = indices[3 * i + 1];
    sorted[to + 2] = indices[3 * i + 2];
  }
}
