import { forEachChunk } from '../../phases.js';
import type { TriangleMesh } from '../../TriangleMesh.js';

/** Sums over the triangles, relative to the first vertex, so that an object far from its origin loses nothing to rounding. */
interface Sums {
  area: number;
  /** Area normals. */
  normal: [x: number, y: number, z: number];
  /** Middles of triangles, times their areas. */
  moment: [x: number, y: number, z: number];
  /** Scalar products of middles and area normals. */
  volume: number;
}

/**
 * Whether normals point outwards on average: the sign of the volume between the triangles and their centre, which open surfaces have too.
 * Curvature would not tell: a vase with a wall is as hollow as it is round.
 */
export function* facesOutwards(mesh: TriangleMesh, areaNormals: Float64Array): Generator<number, boolean, void> {
  const sums: Sums = { area: 0, normal: [0, 0, 0], moment: [0, 0, 0], volume: 0 };
  yield* forEachChunk(areaNormals.length / 3, (start, end) => addRange(mesh, areaNormals, sums, start, end));
  const { area, normal, moment, volume } = sums;
  return volume * area - (moment[0] * normal[0] + moment[1] * normal[1] + moment[2] * normal[2]) >= 0;
}

function addRange(
  { positions, indices }: TriangleMesh,
  areaNormals: Float64Array,
  sums: Sums,
  start: number,
  end: number,
): void {
  const origin = 3 * indices[0];
  let { area, volume } = sums;
  let [normalX, normalY, normalZ] = sums.normal;
  let [momentX, momentY, momentZ] = sums.moment;
  for (let first = 3 * start; first < 3 * end; first += 3) {
    const a = 3 * indices[first];
    const b = 3 * indices[first + 1];
    const c = 3 * indices[first + 2];
    const nx = areaNormals[first];
    const ny = areaNormals[first + 1];
    const nz = areaNormals[first + 2];
    const x = (positions[a] + positions[b] + positions[c]) / 3 - positions[origin];
    const y = (positions[a + 1] + positions[b + 1] + positions[c + 1]) / 3 - positions[origin + 1];
    const z = (positions[a + 2] + positions[b + 2] + positions[c + 2]) / 3 - positions[origin + 2];
    const size = Math.sqrt(nx * nx + ny * ny + nz * nz);
    area += size;
    volume += x * nx + y * ny + z * nz;
    normalX += nx;
    normalY += ny;
    normalZ += nz;
    momentX += size * x;
    momentY += size * y;
    momentZ += size * z;
  }
  Object.assign(sums, { area, volume });
  sums.normal = [normalX, normalY, normalZ];
  sums.moment = [momentX, momentY, momentZ];
}
