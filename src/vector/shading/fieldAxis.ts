/** The function whose level sets are lines, as in shaders/techniques/engraved/fieldAxis.glsl. */
import { FIELD_CONSTANTS } from '../../look/constants/engravedConstants.js';
import { combined, cross, dot, lengthOf, normalize, type Vec3 } from '../../look/vectors.js';

/** The distance along an axis, or from a lamp. */
export interface Field {
  /** The gradient at the origin, unit. */
  axis: Vec3;
  /** Reciprocal of the distance of its lamp, per tile; 0 for planes across the axis. */
  bend: number;
}

/** The fields that lines may be cut by. */
export type CutField = 'light' | 'towards' | 'x' | 'y' | 'z' | 'slant';

const { SLANT, UPRIGHT } = FIELD_CONSTANTS;

const AXES: Readonly<Record<'x' | 'y' | 'z' | 'slant', Vec3>> = {
  x: [1, 0, 0],
  y: [0, 1, 0],
  z: [0, 0, 1],
  slant: SLANT,
};

/** A unit vector across another, continuous in it. */
export const across = (axis: Vec3): Vec3 => normalize(cross(axis, Math.abs(axis[1]) < UPRIGHT ? [0, 1, 0] : [0, 0, 1]));

/**
 * The field of the first family.
 *
 * @param light a result of `fieldLight`
 * @param rotation of strokes from the tangent to the light, radians
 */
export function firstField(lineField: CutField, { axis, bend }: Field, rotation: number): Field {
  const [cosine, sine] = [Math.cos(rotation), Math.sin(rotation)];
  if (lineField === 'light') return { axis: combined(cosine, axis, sine, across(axis)), bend: cosine * bend };
  if (lineField === 'towards') return { axis: combined(cosine, across(axis), -sine, axis), bend: -sine * bend };
  return { axis: AXES[lineField], bend: 0 };
}

/** The value of a field at a point, 0 at the origin, and its gradient there, unit. The point is in field space, tiles. */
export function fieldAt({ axis, bend }: Field, point: Vec3): { value: number; gradient: Vec3 } {
  const toLamp = combined(1, axis, -bend, point);
  const far = Math.max(lengthOf(toLamp), 1e-6);
  const sum = combined(1, axis, 1, toLamp);
  return { value: dot(point, sum) / (1 + far), gradient: combined(1 / far, toLamp, 0, toLamp) };
}
