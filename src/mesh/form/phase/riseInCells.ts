import { forEachChunk } from '../../phases.js';
import type { FormSeam } from '../cutForm.js';
import type { FormSurface } from '../FormSurface.js';
import type { PhaseLevel } from './phaseLevels.js';
import { SLOPE_FLOATS } from './phaseSource.js';

/**
 * Computes by how much φ and φ₂ should rise from the seed of its cell to each node of a level, along the path on which the cell
 * has grown.
 *
 * @param slopes see `PhaseSource`
 */
export function* riseInCells(
  surface: Pick<FormSurface, 'mesh'>,
  seam: Pick<FormSeam, 'cornerOf'>,
  slopes: Float32Array,
  level: PhaseLevel,
): Generator<number, Float64Array, void> {
  const { fans, cells } = level;
  const rises = new Float64Array(2 * fans.length);
  if (cells) {
    yield* forEachChunk(fans.length, (start, end) =>
      riseRange(surface, seam, slopes, fans, cells.order, cells.parents, rises, start, end),
    );
  }
  return rises;
}

/** Each node comes after its parent. */
function riseRange(
  { mesh: { positions, indices } }: Pick<FormSurface, 'mesh'>,
  { cornerOf }: Pick<FormSeam, 'cornerOf'>,
  slopes: Float32Array,
  fans: Uint32Array,
  order: Uint32Array,
  parents: Int32Array,
  rises: Float64Array,
  start: number,
  end: number,
): void {
  for (let i = start; i < end; i++) {
    const node = order[i];
    const parent = parents[node];
    if (parent < 0) continue;
    const from = 3 * indices[cornerOf[fans[parent]]];
    const to = 3 * indices[cornerOf[fans[node]]];
    const x = 0.5 * (positions[to] - positions[from]);
    const y = 0.5 * (positions[to + 1] - positions[from + 1]);
    const z = 0.5 * (positions[to + 2] - positions[from + 2]);
    const a = SLOPE_FLOATS * fans[parent];
    const b = SLOPE_FLOATS * fans[node];
    rises[2 * node] =
      rises[2 * parent] +
      (slopes[a] + slopes[b]) * x +
      (slopes[a + 1] + slopes[b + 1]) * y +
      (slopes[a + 2] + slopes[b + 2]) * z;
    rises[2 * node + 1] =
      rises[2 * parent + 1] +
      (slopes[a + 3] + slopes[b + 3]) * x +
      (slopes[a + 4] + slopes[b + 4]) * y +
      (slopes[a + 5] + slopes[b + 5]) * z;
  }
}
