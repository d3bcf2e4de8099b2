import type { BatchedMesh, Material, Mesh, Object3D } from 'three';
import { identityOf } from '../material/geometry/identityOf.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';

/**
 * Every mesh at or below `root` that draws a surface, visible or not. Lines, points and sprites are left out, and so are lines that
 * three.js builds from meshes (`Line2`) and meshes that only show shadows (`ShadowMaterial`).
 */
export function surfaceMeshes(root: Object3D): Mesh[] {
  const meshes: Mesh[] = [];
  root.traverse((object) => {
    if (isSurfaceMesh(object)) meshes.push(object);
  });
  return meshes;
}

/** Whether an object is a mesh that draws a surface (see {@link surfaceMeshes}). */
export const isSurfaceMesh = (object: Object3D): object is Mesh =>
  isMesh(object) && !('isLineSegments2' in object) && materialsOf(object).some(isSurface);

/** The materials of a mesh, without empty places in the array, whose groups three.js does not draw. */
export const materialsOf = ({ material }: Pick<Mesh, 'material'>): Material[] =>
  [material].flat().filter((entry: Material | null | undefined) => entry !== undefined && entry !== null);

/** Whether a material draws a surface, so that hatching can replace it. */
export const isSurface = (material: Material): boolean =>
  !('isShadowMaterial' in material || 'isLineMaterial' in material);

/** Whether a material is a `HatchingMaterial`. */
export const isHatching = (material: Material): material is HatchingMaterial => 'isHatchingMaterial' in material;

const isMesh = (object: Object3D): object is Mesh => 'isMesh' in object;

export const isBatched = (mesh: Mesh): mesh is BatchedMesh => 'isBatchedMesh' in mesh;

/** The identities of the claimed meshes. */
const claimed = new WeakSet<object>();

/** Whether a mesh, or a proxy of it, is hatched or being hatched. */
export const isClaimed = (mesh: Mesh): boolean => claimed.has(identityOf(mesh));

/** Marks meshes as hatched, or as being hatched, until the returned function is called. A second call of that function does nothing. */
export function claimMeshes(meshes: readonly Mesh[]): () => void {
  for (const mesh of meshes) claimed.add(identityOf(mesh));
  let held = meshes;
  return () => {
    for (const mesh of held) claimed.delete(identityOf(mesh));
    held = [];
  };
}
