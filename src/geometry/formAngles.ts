import type { BufferGeometry, Material } from 'three';
import { identityOf } from './identityOf.js';

/** The angle at which lines cross on a geometry, and the material that says which it shall be. */
interface FormAngle {
  readonly material: object;
  angle: number;
  readonly onOther: (angle: number) => void;
}

const angles = new WeakMap<object, FormAngle>();

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
  angles.set(identityOf(geometry), { material: identityOf(material), angle, onOther });
}

/** To be called as a material draws a geometry. Allocates nothing. */
export function noteFormAngle(geometry: BufferGeometry, material: Material & { crossAngle: number }): void {
  const known = angles.get(identityOf(geometry));
  const { crossAngle } = material;
  if (!known || known.angle === crossAngle || known.material !== identityOf(material)) return;
  known.angle = crossAngle;
  known.onOther(crossAngle);
}
