import type { Material, Mesh, Object3D, Texture } from 'three';
import { isHatching, isSurface, materialsOf } from './surfaceMeshes.js';

type Maps = Partial<Record<'map' | 'alphaMap', Texture | null>>;

/**
 * Why `applyHatching` leaves a mesh as it is, although it draws a surface; undefined if it hatches the mesh. Allocates nothing for a
 * mesh with one material.
 *
 * `userData.hatching` of the mesh, or of the nearest object above it that has one, decides: with `false` the mesh is left alone,
 * with `true` it is hatched whatever its material is.
 */
export function leftAlone(mesh: Mesh): string | undefined {
  const wish = wishFor(mesh);
  if (wish === true) return undefined;
  if (wish === false) return 'userData.hatching is false, here or above';
  const { material } = mesh;
  if (!Array.isArray(material)) return material ? keptMaterial(material) : undefined;
  let reason: string | undefined;
  for (const entry of materialsOf(mesh)) {
    if (!isSurface(entry)) continue;
    reason = keptMaterial(entry);
    // The others of its materials are replaced.
    if (reason === undefined) return undefined;
  }
  return reason;
}

/** Whether a material of a mesh is replaced by a hatching material. */
export const isReplaced = (material: Material, mesh: Mesh): boolean =>
  isSurface(material) && !isHatching(material) && (wishFor(mesh) === true || keptMaterial(material) === undefined);

/** Why a material is kept: its own shader, or a picture drawn in each frame, is what it is there for. */
function keptMaterial(material: Material): string | undefined {
  if (isHatching(material)) return undefined;
  if ('isShaderMaterial' in material) return 'its material has a shader of its own';
  if (hasOwnHook(material)) return 'its material changes its shader in onBeforeCompile';
  const { map, alphaMap } = material as Maps;
  if (map?.isRenderTargetTexture || alphaMap?.isRenderTargetTexture) return 'its material shows a render target';
  return undefined;
}

/** What `userData.hatching` of an object, or of the nearest above it that has one, says. */
function wishFor(mesh: Object3D): boolean | undefined {
  for (let object: Object3D | null = mesh; object !== null; object = object.parent) {
    const wish: unknown = object.userData?.hatching;
    if (typeof wish === 'boolean') return wish;
  }
  return undefined;
}

/**
 * Whether a material, or its class, has set `onBeforeCompile`. The class `Material` has it too, and is known by its `needsUpdate`:
 * a page may have loaded three.js twice.
 */
function hasOwnHook(material: Material): boolean {
  let owner: object | null = material;
  while (owner !== null && !Object.hasOwn(owner, 'onBeforeCompile')) owner = Object.getPrototypeOf(owner);
  return owner !== null && !Object.hasOwn(owner, 'needsUpdate');
}
