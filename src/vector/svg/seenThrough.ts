import type { BufferAttribute, BufferGeometry, Material, Plane } from 'three';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import type { Clip, ClipPlane } from '../paint/PaintLook.js';

/** Opacities that differ by less count as equal. */
const SAME = 0.005;

/** Whether all of a material is see-through. three.js draws materials without `transparent` opaque, whatever their opacity. */
const isFaded = (material: Material): boolean =>
  material.transparent || (material.alphaHash && material.alphaTest === 0);

/** The least, the greatest and the mean alpha of vertex colours. */
const alphas = new WeakMap<object, { least: number; most: number; mean: number }>();

function alphaOf(
  { attributes }: BufferGeometry,
  { vertexColors }: Material,
): { least: number; most: number; mean: number } {
  const color = attributes.color as BufferAttribute | undefined;
  if (!vertexColors || color?.itemSize !== 4 || color.count === 0) return { least: 1, most: 1, mean: 1 };
  let known = alphas.get(color);
  if (!known) {
    let [least, most, sum] = [Infinity, -Infinity, 0];
    for (let vertex = 0; vertex < color.count; vertex++) {
      const alpha = color.getW(vertex);
      least = Math.min(least, alpha);
      most = Math.max(most, alpha);
      sum += alpha;
    }
    known = { least, most, mean: sum / color.count };
    alphas.set(color, known);
  }
  return known;
}

/** Whether the opacity of a surface varies between vertices. */
export function variesInOpacity(geometry: BufferGeometry, material: Material): boolean {
  const { least, most } = alphaOf(geometry, material);
  return isFaded(material) && most - least > SAME;
}

/** The share of its tone that a surface prints. */
export function opacityOf(material: Material, geometry: BufferGeometry): number {
  if (!isFaded(material)) return 1;
  const opacity = material.opacity * alphaOf(geometry, material).mean;
  return opacity > 1 - SAME ? 1 : opacity;
}

/** The share of what lies behind a material that stays visible: 0 for opaque ones. */
export function leftBehind(material: Material, geometry: BufferGeometry): number {
  if (!isFaded(material)) return 0;
  const paper = 'isHatchingMaterial' in material ? (material as HatchingMaterial).paperOpacity : 1;
  return 1 - opacityOf(material, geometry) * paper;
}

/** The planes that clip everything, with those of a material; null for none. */
export function clipOf(
  { clippingPlanes, clipIntersection }: Pick<Material, 'clippingPlanes' | 'clipIntersection'>,
  everywhere: readonly Plane[],
): Clip | null {
  const own = clippingPlanes ?? [];
  if (own.length + everywhere.length === 0) return null;
  const each = clipIntersection ? everywhere : [...everywhere, ...own];
  return { each: each.map(numbersOf), together: clipIntersection ? own.map(numbersOf) : [] };
}

/** The clipping planes of a material's shadow: planes that clip everything do not clip shadows. */
export const shadowClipOf = (material: Material): Clip | null => (material.clipShadows ? clipOf(material, []) : null);

const numbersOf = ({ normal: { x, y, z }, constant }: Plane): ClipPlane => [x, y, z, constant];
