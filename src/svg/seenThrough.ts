import type { Material } from 'three';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import { isBlended, type Painted } from './PaintReader.js';

/** Whether what lies behind a material may be seen through all of it. three.js draws others opaque, whatever their opacity is. */
const isFaded = (material: Material): boolean =>
  (material.transparent || (material.alphaHash && material.alphaTest === 0)) && !isBlended(material as Painted);

/** The share of its tone with which a surface is drawn. */
export const opacityOf = (material: Material): number => (isFaded(material) ? material.opacity : 1);

/** The share that a material leaves of what lies behind it: 0 of those that hide it. */
export function leftBehind(material: Material): number {
  if (!isFaded(material)) return 0;
  const paper = 'isHatchingMaterial' in material ? (material as HatchingMaterial).paperOpacity : 1;
  return 1 - material.opacity * paper;
}
