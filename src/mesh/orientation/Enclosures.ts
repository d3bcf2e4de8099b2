import { measureBounds } from '../measureBounds.js';
import { mapAxes, project, projectionOf } from '../parallelProjection.js';
import { runToEnd } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';
import { NO_PATCH, type Patches } from './consistentPatches.js';

/** Lines along which a point is tested. Where a line runs along an edge, the others decide. */
const LINES = 3;
/** Columns to a side. */
const SIZE = 64;

/** The triangles of all patches in columns along a line, so that only few are tested for a point. */
interface Columns {
  /** A matrix with three rows of four, to columns and depth. */
  projection: Float64Array;
  /** x, y in columns and depth of each vertex. */
  projected: Float32Array;
  /** For each column where its triangles begin in `triangles`. */
  starts: Uint32Array;
  triangles: Uint32Array;
}

/** Tells which patches enclose a point: those of which lines from the point cross an odd number of triangles. Of open ones, most lines do. */
export class Enclosures {
  private readonly columns: readonly Columns[];

  constructor(
    private readonly mesh: TriangleMesh,
    private readonly patches: Patches,
  ) {
    this.columns = Array.from({ length: LINES }, (_, line) => columnsOf(mesh, patches, line));
  }

  /** The patches that enclose a point. */
  around(point: readonly [number, number, number]): Set<number> {
    const votes = new Map<number, number>();
    for (const columns of this.columns) {
      for (const [patch, crossings] of this.crossings(columns, point))
        if (crossings % 2 === 1) votes.set(patch, (votes.get(patch) ?? 0) + 1);
    }
    return new Set([...votes].filter(([, count]) => 2 * count > LINES).map(([patch]) => patch));
  }

  /** How many triangles of each patch lie above a point. */
  private crossings({ projection: p, projected, starts, triangles }: Columns, [x, y, z]: readonly number[]) {
    const { indices } = this.mesh;
    const [u, v, depth] = [0, 4, 8].map((row) => p[row] * x + p[row + 1] * y + p[row + 2] * z + p[row + 3]);
    const found = new Map<number, number>();
    const column = columnAt(u) + SIZE * columnAt(v);
    for (let i = starts[column]; i < starts[column + 1]; i++) {
      const [a, b, c] = [0, 1, 2].map((k) => 3 * indices[3 * triangles[i] + k]);
      const bx = projected[b] - projected[a];
      const by = projected[b + 1] - projected[a + 1];
      const cx = projected[c] - projected[a];
      const cy = projected[c + 1] - projected[a + 1];
      const area = bx * cy - by * cx;
      if (area === 0) continue;
      const shareB = ((u - projected[a]) * cy - (v - projected[a + 1]) * cx) / area;
      const shareC = ((v - projected[a + 1]) * bx - (u - projected[a]) * by) / area;
      if (shareB < 0 || shareC < 0 || shareB + shareC > 1) continue;
      const above =
        projected[a + 2] * (1 - shareB - shareC) + projected[b + 2] * shareB + projected[c + 2] * shareC > depth;
      const patch = this.patches.patchOf[triangles[i]];
      if (above) found.set(patch, (found.get(patch) ?? 0) + 1);
    }
    return found;
  }
}

const columnAt = (place: number): number => Math.min(Math.max(Math.floor(place), 0), SIZE - 1);

function columnsOf(mesh: TriangleMesh, { patchOf }: Patches, line: number): Columns {
  const { positions, indices } = mesh;
  const { min, max, radius } = runToEnd(measureBounds(mesh));
  const center: typeof min = [0.5 * (min[0] + max[0]), 0.5 * (min[1] + max[1]), 0.5 * (min[2] + max[2])];
  const projection = projectionOf(mapAxes(line), { center, radius }, SIZE);
  const projected = new Float32Array(positions.length);
  project(positions, projected, projection, 0, positions.length / 3);
  const starts = new Uint32Array(SIZE * SIZE + 1);
  const forEachEntry = (visit: (column: number, triangle: number) => void): void => {
    for (let triangle = 0; triangle < patchOf.length; triangle++) {
      if (patchOf[triangle] === NO_PATCH) continue;
      const a = 3 * indices[3 * triangle];
      const b = 3 * indices[3 * triangle + 1];
      const c = 3 * indices[3 * triangle + 2];
      const right = columnAt(Math.max(projected[a], projected[b], projected[c]));
      const top = columnAt(Math.max(projected[a + 1], projected[b + 1], projected[c + 1]));
      const left = columnAt(Math.min(projected[a], projected[b], projected[c]));
      for (let y = columnAt(Math.min(projected[a + 1], projected[b + 1], projected[c + 1])); y <= top; y++)
        for (let x = left; x <= right; x++) visit(x + SIZE * y, triangle);
    }
  };
  forEachEntry((column) => void starts[column + 1]++);
  for (let column = 0; column < SIZE * SIZE; column++) starts[column + 1] += starts[column];
  const slots = starts.slice();
  const triangles = new Uint32Array(starts[SIZE * SIZE]);
  forEachEntry((column, triangle) => {
    triangles[slots[column]++] = triangle;
  });
  return { projection, projected, starts, triangles };
}
