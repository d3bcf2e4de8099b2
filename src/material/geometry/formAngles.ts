import type { BufferGeometry, Material } from 'three';
import { identityOf } from './identityOf.js';

/** The angle at which lines cross on a geometry, and the material that decides it. */
interface FormAngle {
  readonly material: object;
  angle: number;
  readonly onOther: (angle: number) => void;
}

const angles = new WeakMap<object, FormAngle>();
/** Whether any geometry is watched: if not, meshes need not be looked up in each frame. */
let isWatching = false;

/**
 * Watches whether lines still cross at the angle that a geometry was prepared for.
 *
 * @param angle the angle that the geometry was prepared for, in radians
 * @param onOther called once for each different angle that the material has when it draws the geometry
 */
export function watchFormAngle(
  geometry: BufferGeometry,
  material: Material,
  angle: number,
  onOther: (angle: number) => void,
): void {
  isWatching = true;
  angles.set(identityOf(geometry), { material: identityOf(material), angle, onOther });
}

/** Whether the angle of a material has changed since it last drew the geometry. Allocates nothing. */
export function hasOtherFormAngle(geometry: BufferGeometry, material: Material & { crossAngle: number }): boolean {
  if (!isWatching) return false;
  const known = angles.get(identityOf(geometry));
  return known !== undefined && known.angle !== material.crossAngle && known.material === identityOf(material);
}

/** Must be called when a material draws a geometry. Allocates nothing. */
export function noteFormAngle(geometry: BufferGeometry, material: Material & { crossAngle: number }): void {
  if (!hasOtherFormAngle(geometry, material)) return;
  const known = angles.get(identityOf(geometry))!;
  known.angle = material.crossAngle;
  known.onOther(known.angle);
}
