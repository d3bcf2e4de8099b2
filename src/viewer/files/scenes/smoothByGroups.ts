import { BufferAttribute, type BufferGeometry } from 'three';

/** The sum of face normals around a point for one set of smoothing groups. */
interface Sum {
  groups: number;
  normal: [x: number, y: number, z: number];
}

/**
 * Returns a geometry without an index, with normals by smoothing groups: each corner has the angle-weighted mean of adjacent faces that
 * share a group with its own face. Faces without a group are flat. Points at one place count as one, since texture seams split them.
 *
 * @param groups per triangle, one bit per group
 */
export function smoothByGroups(geometry: BufferGeometry, groups: ArrayLike<number>): BufferGeometry {
  const smooth = geometry.index ? geometry.toNonIndexed() : geometry.clone();
  const { array: points } = smooth.getAttribute('position');
  const normals = new Float32Array(points.length);
  const around = new Map<string, Sum[]>();
  const placeOf = (corner: number): string => `${points[corner]} ${points[corner + 1]} ${points[corner + 2]}`;
  const face: [number, number, number] = [0, 0, 0];
  for (let at = 0; at + 9 <= points.length; at += 9) {
    faceNormal(points, at, face);
    normals.set(face, at);
    normals.set(face, at + 3);
    normals.set(face, at + 6);
    const own = groups[at / 9] ?? 0;
    if (own === 0) continue;
    for (let k = 0; k < 3; k++) {
      const weight = angleAt(points, at + 3 * k, at + 3 * ((k + 1) % 3), at + 3 * ((k + 2) % 3));
      const place = placeOf(at + 3 * k);
      const sums = around.get(place) ?? [];
      around.set(place, sums);
      const sum = sums.find((one) => one.groups === own) ?? { groups: own, normal: [0, 0, 0] };
      if (!sums.includes(sum)) sums.push(sum);
      for (let axis = 0; axis < 3; axis++) sum.normal[axis] += weight * face[axis];
    }
  }
  for (let at = 0; at + 3 <= points.length; at += 3) {
    const own = groups[Math.floor(at / 9)] ?? 0;
    if (own === 0) continue;
    const total: [number, number, number] = [0, 0, 0];
    for (const sum of around.get(placeOf(at)) ?? [])
      if ((sum.groups & own) !== 0) for (let axis = 0; axis < 3; axis++) total[axis] += sum.normal[axis];
    const length = Math.hypot(...total);
    for (let axis = 0; axis < 3; axis++) normals[at + axis] = length > 0 ? total[axis] / length : 0;
  }
  smooth.setAttribute('normal', new BufferAttribute(normals, 3));
  return smooth;
}

/** Writes the unit normal of a triangle; zero if it has no area. */
function faceNormal(points: ArrayLike<number>, at: number, normal: [number, number, number]): void {
  const [ux, uy, uz] = [3, 4, 5].map((k) => points[at + k] - points[at + k - 3]);
  const [vx, vy, vz] = [6, 7, 8].map((k) => points[at + k] - points[at + k - 6]);
  const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(x, y, z);
  const scale = length > 0 && length < Infinity ? 1 / length : 0;
  normal[0] = scale * x || 0;
  normal[1] = scale * y || 0;
  normal[2] = scale * z || 0;
}

/** The angle of a triangle at its corner `o`. */
function angleAt(points: ArrayLike<number>, o: number, a: number, b: number): number {
  let [dot, lengthA, lengthB] = [0, 0, 0];
  for (let axis = 0; axis < 3; axis++) {
    const [u, v] = [points[a + axis] - points[o + axis], points[b + axis] - points[o + axis]];
    dot += u * v;
    lengthA += u * u;
    lengthB += v * v;
  }
  const cosine = dot / Math.sqrt(lengthA * lengthB);
  return cosine >= -1 && cosine <= 1 ? Math.acos(cosine) : 0;
}
