import type { Material, Mesh, Object3D, Texture } from 'three';
import { isHatching, isSurface, materialsOf } from './surfaceMeshes.js';

type Maps = Partial<Record<'map' | 'alphaMap', Texture | null>>;

/**
 * The reason why `applyHatching` leaves a mesh unchanged although it draws a surface; undefined if it hatches the mesh. Allocates
 * nothing for a mesh with one material.
 *
 * `userData.hatching` of the mesh, or of its nearest ancestor that has it, decides: with `false` the mesh is left alone, with `true` it
 * is hatched whatever its material is.
 */
export function leftAlone(mesh: Mesh): string | undefined {
  const wish = hatchingFlagOf(mesh);
  if (wish === true) return undefined;
  if (wish === false) return 'userData.hatching is false, here or above';
  const { material } = mesh;
  if (!Array.isArray(material)) return material ? keptMaterial(material) : undefined;
  let reason: string | undefined;
  for (const entry of materialsOf(mesh)) {
    if (!isSurface(entry)) continue;
    reason = keptMaterial(entry);
    // Other materials of the mesh are replaced.
    if (reason === undefined) return undefined;
  }
  return reason;
}

/** Whether a material of a mesh is replaced by a hatching material. */
export const isReplaced = (material: Material, mesh: Mesh): boolean =>
  isSurface(material) &&
  !isHatching(material) &&
  (hatchingFlagOf(mesh) === true || keptMaterial(material) === undefined);

/** The reason why a material is kept: it has its own shader, or shows a picture that is rendered in each frame. */
function keptMaterial(material: Material): string | undefined {
  if (isHatching(material)) return undefined;
  if ('isShaderMaterial' in material) return 'its material has a shader of its own';
  if (hasOwnHook(material)) return 'its material changes its shader in onBeforeCompile';
  const { map, alphaMap } = material as Maps;
  if (map?.isRenderTargetTexture || alphaMap?.isRenderTargetTexture) return 'its material shows a render target';
  return undefined;
}

/** The value of `userData.hatching` of an object or of its nearest ancestor that has it. */
function hatchingFlagOf(mesh: Object3D): boolean | undefined {
  for (let object: Object3D | null = mesh; object !== null; object = object.parent) {
    const wish: unknown = object.userData?.hatching;
    if (typeof wish === 'boolean') return wish;
  }
  return undefined;
}

/**
 * Whether a material, or its class, overrides `onBeforeCompile`. The base class `Material` has one too; it is recognised by its
 * `needsUpdate`, because a page may have loaded three.js twice.
 */
function hasOwnHook(material: Material): boolean {
  let owner: object | null = material;
  while (owner !== null && !Object.hasOwn(owner, 'onBeforeCompile')) owner = Object.getPrototypeOf(owner);
  return owner !== null && !Object.hasOwn(owner, 'needsUpdate');
}
