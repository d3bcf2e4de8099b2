import type { Material, Mesh, Object3D } from 'three';

/** Names that programs give to everything. */
const GENERIC = /^(object|mesh|node|group|polysurface|defaultmaterial|default|geometry|shape|id)?[\s_.:\-\d]*$/i;

/**
 * The names of meshes in a scene: their own, or that of the group that they belong to where they have none that says something. Meshes of
 * one group are told apart by their materials.
 *
 * @param root the scene, whose own name is not used
 * @returns one name per mesh, empty where the file has none
 */
export function meshNames(root: Object3D, meshes: readonly Mesh[]): string[] {
  const counts = meshesBelow(root, meshes);
  return meshes.map((mesh) => {
    const own = isPrimitive(mesh) ? '' : nameOf(mesh);
    if (!GENERIC.test(own)) return own;
    for (let object = mesh.parent; object && object !== root; object = object.parent) {
      const count = counts.get(object) ?? 0;
      const name = nameOf(object);
      // The group of all meshes tells nothing about one of them.
      if (count === meshes.length || GENERIC.test(name)) continue;
      const material = count > 1 ? materialName(mesh.material) : '';
      return material ? `${name}: ${material}` : name;
    }
    return materialName(mesh.material) || own;
  });
}

/** Whether a mesh is one of the primitives of a named glTF node, which three's loader numbers. */
const isPrimitive = ({ userData, parent }: Mesh): boolean =>
  userData.name === undefined && typeof parent?.userData.name === 'string' && parent.children.length > 1;

/** The number of the meshes at or below each object. */
function meshesBelow(root: Object3D, meshes: readonly Mesh[]): Map<Object3D, number> {
  const counts = new Map<Object3D, number>();
  for (const mesh of meshes) {
    for (let object: Object3D | null = mesh; object && object !== root; object = object.parent)
      counts.set(object, (counts.get(object) ?? 0) + 1);
  }
  return counts;
}

/** The name of an object in its file: three's glTF loader changes the names of objects, and makes some up. */
function nameOf({ name, userData }: Object3D): string {
  return typeof userData.name === 'string' ? userData.name : name;
}

/** The name of a mesh's only material. */
export function materialName(material: Material | readonly Material[] | undefined): string {
  const [one, ...others] = [material ?? []].flat() as Material[];
  return one && others.length === 0 && !/^__DEFAULT$/.test(one.name) ? one.name : '';
}
