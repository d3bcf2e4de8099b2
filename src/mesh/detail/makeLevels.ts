import { asPhase } from '../phases.js';
import type { Simplifier } from './loadSimplifier.js';
import { type SimplifiableMesh, simplifyTriangles } from './simplifyTriangles.js';

/** The error of the first level, in radii: a quarter of a pixel where the mesh is a thousand pixels high. */
const FIRST_ERROR = 2 ** -11;
/** Number of errors, each twice the one before. The last suits a mesh of some twenty pixels. */
const ERRORS = 7;
/** A level is kept if it has at most this share of the triangles of the level before it. */
const WORTH_KEEPING = 0.7;
/** Meshes of fewer triangles cost no more than their draw call. */
const FEWEST_TRIANGLES = 500;

/** A level: a range of corners, and its distance from the whole mesh. */
export interface DetailLevel {
  start: number;
  count: number;
  /** In object units. */
  error: number;
}

/** Levels of detail of one mesh, which share its vertices. */
export interface DetailLevels {
  /** The corners of all levels, the whole mesh first. */
  indices: Uint32Array<ArrayBuffer>;
  levels: DetailLevel[];
}

/**
 * Simplifies a mesh repeatedly, each time to half of its triangles or fewer. Every level uses vertices of the level before it.
 *
 * @param radius of the mesh, in object units
 */
export function* makeLevels(
  mesh: SimplifiableMesh,
  whole: Uint32Array<ArrayBuffer>,
  radius: number,
  simplifier: Simplifier,
): Generator<number, DetailLevels, void> {
  const kept = [{ indices: whole, error: 0 }];
  let last = kept[0];
  for (let i = 0; i < ERRORS && last.indices.length > 3 * FEWEST_TRIANGLES; i++) {
    const error = radius * FIRST_ERROR * 2 ** i;
    // Errors of levels that are made from each other add up.
    const allowed = error - last.error;
    // Each level has about half the triangles of the one before.
    const made = yield* asPhase(
      simplifyTriangles(mesh, last.indices, allowed, simplifier, (i % 2) / 2),
      1 - 2 ** -i,
      1 - 2 ** -(i + 1),
    );
    if (made.indices.length === 0) break;
    if (made.indices.length > WORTH_KEEPING * last.indices.length) continue;
    last = { indices: made.indices, error: last.error + made.error };
    kept.push(last);
  }
  const indices = new Uint32Array(kept.reduce((sum, level) => sum + level.indices.length, 0));
  const levels: DetailLevel[] = [];
  let start = 0;
  for (const level of kept) {
    indices.set(level.indices, start);
    levels.push({ start, count: level.indices.length, error: level.error });
    start += level.indices.length;
  }
  return { indices, levels };
}
