import type { BufferGeometry, Material, Mesh } from 'three';
import { FIELD_FRAME } from '../material/fieldFrameName.js';
import { identityOf } from '../material/geometry/identityOf.js';
import { hatchNormal } from '../mesh/bake/attributeLayouts.js';
import type { MeshLook } from './geometryPlans.js';
import { isHatching, materialsOf } from './surfaceMeshes.js';

/** The former material in place of a new one, or the same. */
export type InPlaceOf = ReadonlyMap<Material, Material>;

/** How the looks of meshes are exchanged, whatever else was set on them in the meantime. */

/** The present look of a mesh. */
export const lookOf = (mesh: Mesh): MeshLook => ({
  mesh,
  geometry: mesh.geometry,
  material: mesh.material,
  fieldFrame: mesh.userData[FIELD_FRAME],
});

/** Replaces the geometry and material of `from` by those of `to`. Others that were set in the meantime stay. */
export function exchangeLook(from: MeshLook, to: MeshLook): void {
  const { mesh } = from;
  if (isSame(mesh.geometry, from.geometry) || isOccluded(mesh.geometry, from.geometry)) mesh.geometry = to.geometry;
  if (isSame(mesh.material, from.material)) mesh.material = to.material;
  if (to.fieldFrame === undefined) delete mesh.userData[FIELD_FRAME];
  else mesh.userData[FIELD_FRAME] = to.fieldFrame;
}

/** Whether two objects are the same, or proxies of the same object. */
export const isSame = (a: object | null, b: object | null): boolean =>
  a === b || (!!a && !!b && identityOf(a) === identityOf(b));

/** Whether a geometry is a clone of a baked one, with occlusion of its own. */
export const isOccluded = (geometry: BufferGeometry | null, baked: BufferGeometry): boolean =>
  hatchNormal.name in (geometry?.attributes ?? {}) &&
  hatchNormal.name in baked.attributes &&
  geometry!.attributes.position === baked.attributes.position;

/** Whether a mesh still has its hatched look, or had its former one set back, or another one that is hatched, too. */
export function isAsHatched({ mesh, before, after }: { mesh: Mesh; before: MeshLook; after: MeshLook }): boolean {
  const { geometry } = mesh;
  const isKnown = isSame(geometry, after.geometry) || isSame(geometry, before.geometry);
  if (!isKnown && !(geometry && hatchNormal.name in geometry.attributes)) return false;
  if (isSame(mesh.material, after.material) || isSame(mesh.material, before.material)) return true;
  return materialsOf(mesh).every(isHatching);
}

/** A material, or each of several, after some were put in place of others. */
export const replaced = (material: Material | Material[], inPlaceOf: InPlaceOf): Material | Material[] =>
  Array.isArray(material) ? material.map((one) => inPlaceOf.get(one) ?? one) : (inPlaceOf.get(material) ?? material);
