import type { BatchedMesh, Material, Mesh, Object3D } from 'three';

/**
 * Every mesh at or below `root` that draws a surface, visible or not. Leaves out lines, points and sprites, also lines that
 * three.js builds from meshes (`Line2`), and meshes that only receive shadows.
 */
export function surfaceMeshes(root: Object3D): Mesh[] {
  const meshes: Mesh[] = [];
  root.traverse((object) => {
    if (isMesh(object) && !('isLineSegments2' in object) && materialsOf(object).some(isSurface)) {
      meshes.push(object);
    }
  });
  return meshes;
}

/** The materials of a mesh. three.js leaves groups undrawn whose place in the array is empty. */
export const materialsOf = ({ material }: Pick<Mesh, 'material'>): Material[] =>
  [material].flat().filter((one: Material | null | undefined) => one !== undefined && one !== null);

/** Whether a material draws a surface, so that hatching can replace it. */
export const isSurface = (material: Material): boolean =>
  !('isShadowMaterial' in material || 'isLineMaterial' in material);

const isMesh = (object: Object3D): object is Mesh => 'isMesh' in object;

export const isBatched = (mesh: Mesh): mesh is BatchedMesh => 'isBatchedMesh' in mesh;
