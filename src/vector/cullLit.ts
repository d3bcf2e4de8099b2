import { combined, dot, lengthOf, type Vec3, vectorAt } from '../look/vectors.js';
import { CASTS_BACK, CASTS_FRONT } from './Bvh.js';
import { type LineSurface, STRIDE, WORLD } from './LineSurface.js';
import type { GroundLook } from './shading/groundShadow.js';
import { arriving } from './shading/radiance.js';
import type { Illumination } from './ToneReader.js';

/** Bound of the softness of maps, as a share of the distance. */
const SPREAD = 0.05;
/** Triangles per step. */
const CHUNK = 4096;

/** The bounding sphere of all occluders, world space. */
export interface CastingSphere {
  centre: Vec3;
  radius: number;
}

/** The bounding sphere of all triangles that cast shadows; null for none. */
export function* castingSphere(
  corners: Float64Array,
  sides: Uint8Array,
): Generator<number, CastingSphere | null, void> {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (let t = 0; t < sides.length; t++) {
    if (t % CHUNK === CHUNK - 1) yield 0;
    if ((sides[t] & (CASTS_FRONT | CASTS_BACK)) === 0) continue;
    for (let i = 9 * t; i < 9 * t + 9; i++) {
      const axis = i % 3;
      least[axis] = Math.min(least[axis], corners[i]);
      most[axis] = Math.max(most[axis], corners[i]);
    }
  }
  if (!(least[0] <= most[0])) return null;
  const at = (axis: number) => 0.5 * (least[axis] + most[axis]);
  const centre: Vec3 = [at(0), at(1), at(2)];
  return { centre, radius: Math.hypot(...most.map((end, axis) => end - centre[axis])) };
}

/** Removes the triangles of a ground that no shadow can reach, which have no lines. Changes the surface. Yields meanwhile. */
export function* cullLit(
  surface: LineSurface,
  casters: CastingSphere | null,
  { lamps, shadows }: Illumination,
  { softness }: GroundLook,
): Generator<number, void, void> {
  const { vertices, triangles, parents } = surface;
  const casting = lamps.filter(({ castsShadow }, i) => castsShadow && shadows[i]);
  const cornerOf = (c: number): Vec3 => vectorAt(vertices, STRIDE * triangles[c] + WORLD);
  const mayBeShaded = (t: number): boolean => {
    if (!casters) return false;
    const [a, b, c] = [cornerOf(3 * t), cornerOf(3 * t + 1), cornerOf(3 * t + 2)];
    const middle = combined(1 / 3, combined(1, a, 1, b), 1 / 3, c);
    const size = Math.max(...[a, b, c].map((corner) => lengthOf(combined(1, corner, -1, middle))));
    const way = combined(1, casters.centre, -1, middle);
    const room = casters.radius + size;
    return casting.some((lamp) => {
      const { direction } = arriving(lamp, middle);
      const along = dot(way, direction);
      const beside = lengthOf(combined(1, way, -along, direction));
      // Rays open with distance, and the softness of a map is a share of its width.
      return along > -room && beside < room + (0.5 * softness + SPREAD) * (lengthOf(way) + room);
    });
  };
  const kept: number[] = [];
  const keptParents: number[] = [];
  for (let t = 0; t < parents.length; t++) {
    if (t % CHUNK === CHUNK - 1) yield 0;
    if (!mayBeShaded(t)) continue;
    kept.push(triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]);
    keptParents.push(parents[t]);
  }
  surface.triangles = Int32Array.from(kept);
  surface.parents = Int32Array.from(keptParents);
}
