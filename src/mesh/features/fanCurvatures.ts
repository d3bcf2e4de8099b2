import { doubleArea } from '../computeAreaNormals.js';
import type { Fans } from '../normals/fans.js';
import { chunkPhase } from '../phases.js';
import type { TriangleMesh } from '../TriangleMesh.js';

/** Floats per fan: xx, xy, xz, yy, yz, zz of a symmetric matrix. */
export const TENSOR_FLOATS = 6;

/** A triangle is too thin to measure its curvature if the determinant of the system is below this share of its scale. */
const MIN_DETERMINANT = 1e-6;

/** The arrays of the loops over triangles and fans. */
interface Curvatures {
  positions: Float32Array;
  indices: Uint32Array;
  ofCorner: Uint32Array;
  areaNormals: Float64Array;
  /** Unit normals, three floats per fan. */
  normals: Float32Array;
  tensors: Float32Array<ArrayBuffer>;
  /** For each fan the area that its tensor was summed over. */
  areas: Float32Array;
  /** The current triangle: its normal, the axes u and v of its frame, and p, q, r of its tensor (p q; q r). */
  fitted: Float64Array;
}

/** The number of floats in `fitted`. */
const FITTED_FLOATS = 12;

/**
 * Computes the curvature tensor K of each fan, in 1 / object unit: along the unit tangent w the surface has the normal curvature
 * wᵀKw, which is positive where the surface is convex. For a sphere of radius r it is 1/r along every tangent.
 *
 * The method is that of Rusinkiewicz, "Estimating curvatures and their derivatives on triangle meshes", 2004: a tensor is fitted
 * to the differences of the normals along the edges of each triangle, turned into the tangent plane of each of its fans, and
 * averaged by area. It is stored as a matrix in object space, so that shader and bake need no common tangent frame.
 *
 * @param normals unit normals, three per fan
 */
export function* fanCurvatures(
  { positions, indices }: TriangleMesh,
  areaNormals: Float64Array,
  fans: Fans,
  normals: Float32Array,
): Generator<number, Float32Array<ArrayBuffer>, void> {
  const { ofCorner, count } = fans;
  const tensors = new Float32Array(TENSOR_FLOATS * count);
  const areas = new Float32Array(count);
  const fitted = new Float64Array(FITTED_FLOATS);
  const curvatures = { positions, indices, ofCorner, areaNormals, normals, tensors, areas, fitted };
  yield* chunkPhase(indices.length / 3, 0, 0.9, (start, end) => addTriangles(curvatures, start, end));
  yield* chunkPhase(count, 0.9, 1, (start, end) => divideRange(curvatures, start, end));
  return tensors;
}

/** Adds the tensors of a range of triangles, times their areas, to those of their fans. */
function addTriangles(curvatures: Curvatures, start: number, end: number): void {
  for (let triangle = start; triangle < end; triangle++) {
    const area = doubleArea(curvatures.areaNormals, triangle);
    if (area === 0 || !fitTensor(curvatures, 3 * triangle, area)) continue;
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) addTensor(curvatures, corner, area);
  }
}

/** Fits the tensor of the triangle whose first corner is `first`. Returns false if the triangle is too thin. */
function fitTensor(
  { positions, indices, ofCorner, areaNormals, normals, fitted }: Curvatures,
  first: number,
  area: number,
): boolean {
  const fx = areaNormals[first] / area;
  const fy = areaNormals[first + 1] / area;
  const fz = areaNormals[first + 2] / area;

  // The frame of the triangle: u along edge 0, v = f × u.
  const origin = 3 * indices[first];
  const target = 3 * indices[first + 1];
  let ux = positions[target] - positions[origin];
  let uy = positions[target + 1] - positions[origin + 1];
  let uz = positions[target + 2] - positions[origin + 2];
  const length = Math.sqrt(ux * ux + uy * uy + uz * uz);
  ux /= length;
  uy /= length;
  uz /= length;
  const vx = fy * uz - fz * uy;
  const vy = fz * ux - fx * uz;
  const vz = fx * uy - fy * ux;

  // Least squares of K·e = Δn over the three edges, with K = (p q; q r) and all vectors in the frame.
  let a = 0;
  let b = 0;
  let c = 0;
  let right0 = 0;
  let right1 = 0;
  let right2 = 0;
  for (let k = 0; k < 3; k++) {
    const corner = first + k;
    const next = first + ((k + 1) % 3);
    const from = 3 * indices[corner];
    const to = 3 * indices[next];
    const ex = positions[to] - positions[from];
    const ey = positions[to + 1] - positions[from + 1];
    const ez = positions[to + 2] - positions[from + 2];
    const fanFrom = 3 * ofCorner[corner];
    const fanTo = 3 * ofCorner[next];
    const nx = normals[fanTo] - normals[fanFrom];
    const ny = normals[fanTo + 1] - normals[fanFrom + 1];
    const nz = normals[fanTo + 2] - normals[fanFrom + 2];
    const e0 = ex * ux + ey * uy + ez * uz;
    const e1 = ex * vx + ey * vy + ez * vz;
    const n0 = nx * ux + ny * uy + nz * uz;
    const n1 = nx * vx + ny * vy + nz * vz;
    a += e0 * e0;
    b += e0 * e1;
    c += e1 * e1;
    right0 += e0 * n0;
    right1 += e1 * n0 + e0 * n1;
    right2 += e1 * n1;
  }
  // The system (a b 0; b a+c b; 0 b c)(p q r)ᵀ = right, by elimination of p and r.
  const determinant = a * c * (a + c) - b * b * (a + c);
  if (!(determinant > MIN_DETERMINANT * (a + c) * (a + c) * (a + c))) return false;
  const q = (right1 * a * c - b * (right0 * c + right2 * a)) / determinant;
  const p = (right0 - b * q) / a;
  const r = (right2 - b * q) / c;
  fitted[0] = fx;
  fitted[1] = fy;
  fitted[2] = fz;
  fitted[3] = ux;
  fitted[4] = uy;
  fitted[5] = uz;
  fitted[6] = vx;
  fitted[7] = vy;
  fitted[8] = vz;
  fitted[9] = p;
  fitted[10] = q;
  fitted[11] = r;
  return true;
}

/** Turns the fitted tensor from its plane, with normal f, into the tangent plane of the corner's fan, and adds it. */
function addTensor({ ofCorner, normals, tensors, areas, fitted }: Curvatures, corner: number, area: number): void {
  const fx = fitted[0];
  const fy = fitted[1];
  const fz = fitted[2];
  const ux = fitted[3];
  const uy = fitted[4];
  const uz = fitted[5];
  const vx = fitted[6];
  const vy = fitted[7];
  const vz = fitted[8];
  const p = fitted[9];
  const q = fitted[10];
  const r = fitted[11];
  const fan = ofCorner[corner];
  const nx = normals[3 * fan];
  const ny = normals[3 * fan + 1];
  const nz = normals[3 * fan + 2];
  const cosine = fx * nx + fy * ny + fz * nz;
  // The triangle is folded back onto the fan, where no rotation is clearly the shortest.
  if (cosine < -0.5) return;
  // The shortest rotation that takes f to n takes a tangent t of the triangle to t − (n·t)/(1 + f·n)·(f + n).
  const scaleU = (ux * nx + uy * ny + uz * nz) / (1 + cosine);
  const scaleV = (vx * nx + vy * ny + vz * nz) / (1 + cosine);
  const u0 = ux - scaleU * (fx + nx);
  const u1 = uy - scaleU * (fy + ny);
  const u2 = uz - scaleU * (fz + nz);
  const v0 = vx - scaleV * (fx + nx);
  const v1 = vy - scaleV * (fy + ny);
  const v2 = vz - scaleV * (fz + nz);
  const i = TENSOR_FLOATS * fan;
  tensors[i] += area * (p * u0 * u0 + 2 * q * u0 * v0 + r * v0 * v0);
  tensors[i + 1] += area * (p * u0 * u1 + q * (u0 * v1 + u1 * v0) + r * v0 * v1);
  tensors[i + 2] += area * (p * u0 * u2 + q * (u0 * v2 + u2 * v0) + r * v0 * v2);
  tensors[i + 3] += area * (p * u1 * u1 + 2 * q * u1 * v1 + r * v1 * v1);
  tensors[i + 4] += area * (p * u1 * u2 + q * (u1 * v2 + u2 * v1) + r * v1 * v2);
  tensors[i + 5] += area * (p * u2 * u2 + 2 * q * u2 * v2 + r * v2 * v2);
  areas[fan] += area;
}

function divideRange({ tensors, areas }: Curvatures, start: number, end: number): void {
  for (let fan = start; fan < end; fan++) {
    if (areas[fan] === 0) continue;
    for (let i = TENSOR_FLOATS * fan; i < TENSOR_FLOATS * (fan + 1); i++) tensors[i] /= areas[fan];
  }
}
