import { triangleOf } from '../../corners.js';
import { TENSOR_FLOATS } from '../../features/fanCurvatures.js';
import { findPatches } from '../../normals/findPatches.js';
import { asPhase, chunkPhase, forEachChunk } from '../../phases.js';
import type { TriangleMesh } from '../../TriangleMesh.js';
import type { FormSurface } from '../FormSurface.js';

/** A piece bends one way if its mean curvature, with its sign, is at least this share of its mean without signs. */
const DECIDED_SHARE = 0.5;

/**
 * For each fan 1 if its piece of the surface is convex and −1 if it is hollow, such as the inside of a vase or a mesh wound inside out. A
 * piece that is both is judged by the winding of the mesh.
 */
export function* bendSigns(surface: FormSurface): Generator<number, Int8Array<ArrayBuffer>, void> {
  const { fans, mesh, areaNormals } = surface;
  const whole = (yield* asPhase(facesOutwards(mesh, areaNormals), 0, 0.3)) ? 1 : -1;
  const { ofTriangle, areas } = yield* asPhase(findPatches(surface), 0.3, 0.8);
  const patchOf = new Uint32Array(fans.count);
  yield* chunkPhase(fans.ofCorner.length, 0.8, 0.9, (start, end) =>
    assignRange(fans.ofCorner, ofTriangle, patchOf, start, end),
  );
  const sums = new Float64Array(areas.length);
  const sizes = new Float64Array(areas.length);
  const signs = new Int8Array(fans.count);
  yield* chunkPhase(fans.count, 0.9, 0.95, (start, end) => sumRange(surface, patchOf, sums, sizes, start, end));
  for (const [patch, sum] of sums.entries()) {
    const isDecided = Math.abs(sum) > DECIDED_SHARE * sizes[patch];
    sums[patch] = isDecided ? Math.sign(sum) : whole;
  }
  for (let fan = 0; fan < signs.length; fan++) signs[fan] = sums[patchOf[fan]];
  yield 1;
  return signs;
}

function assignRange(
  ofCorner: Uint32Array,
  ofTriangle: Uint32Array,
  patchOf: Uint32Array,
  start: number,
  end: number,
): void {
  for (let corner = start; corner < end; corner++) patchOf[ofCorner[corner]] = ofTriangle[triangleOf(corner)];
}

/** Adds the mean curvature of a range of fans to their patches. */
function sumRange(
  { masses, tensors }: FormSurface,
  patchOf: Uint32Array,
  sums: Float64Array,
  sizes: Float64Array,
  start: number,
  end: number,
): void {
  for (let fan = start; fan < end; fan++) {
    const i = TENSOR_FLOATS * fan;
    const bend = masses[fan] * (tensors[i] + tensors[i + 3] + tensors[i + 5]);
    sums[patchOf[fan]] += bend;
    sizes[patchOf[fan]] += Math.abs(bend);
  }
}

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
function* facesOutwards(mesh: TriangleMesh, areaNormals: Float64Array): Generator<number, boolean, void> {
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
