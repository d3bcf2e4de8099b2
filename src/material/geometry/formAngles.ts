import type { BufferGeometry, Material } from 'three';
import { identityOf } from './identityOf.js';

/** The angle at which lines cross on a geometry, and the material that says which it shall be. */
interface FormAngle {
  readonly material: object;
  angle: number;
  readonly onOther: (angle: number) => void;
}

const angles = new WeakMap<object, FormAngle>();
/** Whether any geometry has ever been watched: until then no mesh of any frame has to be looked up. */
let isWatching = false;

/**
 * Watches whether the angle of crossing lines is still the one that a geometry was prepared for.
 *
 * @param angle that it was prepared for, in radians
 * @param onOther called once for each other angle that the material has as it draws the geometry
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

/** Whether a material has another angle than that which it had when it drew the geometry before. Allocates nothing. */
export function hasOtherFormAngle(geometry: BufferGeometry, material: Material & { crossAngle: number }): boolean {
  if (!isWatching) return false;
  const known = angles.get(identityOf(geometry));
  return known !== undefined && known.angle !== material.crossAngle && known.material === identityOf(material);
}

/** To be called as a material draws a geometry. Allocates nothing. */
export function noteFormAngle(geometry: BufferGeometry, material: Material & { crossAngle: number }): void {
  if (!hasOtherFormAngle(geometry, material)) return;
  const known = angles.get(identityOf(geometry))!;
  known.angle = material.crossAngle;
  known.onOther(known.angle);
}
