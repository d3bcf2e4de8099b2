import type { BufferGeometry } from 'three';
import { runTask } from '../worker/runTask.js';
import type { TaskOptions } from '../worker/TaskOptions.js';
import { checkGeometry } from './checkGeometry.js';
import { applyCorners, startCornerGeometry } from './cornerGeometry.js';
import { cornerRange } from './cornerRange.js';
import { extractMesh } from './extractMesh.js';
import { extractWords, keptAttributes } from './vertexAttributes.js';

/** Options of `prepareHatchingGeometry`. */
export interface PrepareHatchingGeometryOptions extends TaskOptions {
  /**
   * How adjacency is stored per vertex. `'corner'`: every corner carries the positions of all six adjacency vertices,
   * 228 bytes per triangle. `'auto'` (the default) chooses; today it always chooses `'corner'`.
   */
  layout?: 'auto' | 'corner' | undefined;
  /**
   * Triangles whose normals differ by more than this angle, in radians from 0 to π, do not blend across their common
   * edge. The default is π/2, the paper's rule (section 3.3). It also bounds the smoothing of normals, which are
   * computed for a geometry that has none.
   */
  creaseAngle?: number | undefined;
}

const PAPER_CREASE_ANGLE = Math.PI / 2;

/**
 * Makes the geometry that `HatchingMaterial` draws: finds the three neighbours of every triangle and stores, for each
 * corner, the positions of the six adjacency vertices (paper, section 3.2, figure 5; `cornerLayout`). Runs in a worker.
 *
 * The result is a new, non-indexed geometry of the triangles in the draw range. Every other attribute of the source is
 * kept in its type, also morph targets, groups, name and user data; smooth normals are added where there are none.
 * Positions become 32-bit floats. `userData.hatching` holds a `HatchingStatistics`. `geometry` itself is never touched.
 *
 * Vertices at exactly the same position count as one, so seams of uv or normal do not separate triangles. Border,
 * non-manifold and degenerate cases are baked so that they contribute nothing, and are counted.
 *
 * Rejects with a TypeError or RangeError that says what to repair, for: something that is not a BufferGeometry; no
 * `position`; no triangles; a count that is not a multiple of three; an index out of range; a position that is not
 * finite; an attribute shorter than `position`; an unknown option. Rejects with the signal's reason when aborted, and
 * with an Error when the worker dies or is disposed of meanwhile.
 */
export async function prepareHatchingGeometry(
  geometry: BufferGeometry,
  options: PrepareHatchingGeometryOptions = {},
): Promise<BufferGeometry> {
  options.signal?.throwIfAborted();
  const creaseAngle = options.creaseAngle ?? PAPER_CREASE_ANGLE;
  checkOptions(options.layout ?? 'auto', creaseAngle);
  const label = checkGeometry(geometry);
  const range = cornerRange(geometry, label);
  const kept = keptAttributes(geometry);
  const prepared = startCornerGeometry(geometry, range);

  const result = await runTask(
    'bake',
    {
      label,
      mesh: extractMesh(geometry, range),
      creaseAngle,
      wantsNormals: !geometry.hasAttribute('normal'),
      attributes: kept.map(({ attribute }) => extractWords(attribute)),
    },
    options,
  );
  applyCorners(prepared, kept, result);
  return prepared;
}

function checkOptions(layout: string, creaseAngle: number): void {
  if (layout === 'pull' || layout === 'indexed') {
    throw new RangeError(
      `prepareHatchingGeometry: the layout '${layout}' is not in this version of three-hatching. Use 'corner', or leave the option out.`,
    );
  }
  if (layout !== 'auto' && layout !== 'corner') {
    throw new RangeError(`prepareHatchingGeometry: unknown layout '${layout}'. Use 'auto' or 'corner'.`);
  }
  if (!(creaseAngle >= 0 && creaseAngle <= Math.PI)) {
    throw new RangeError(
      `prepareHatchingGeometry: creaseAngle is ${creaseAngle}. Pass an angle in radians from 0 to π; 60 degrees is Math.PI / 3.`,
    );
  }
}
