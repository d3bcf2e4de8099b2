import { BufferAttribute, FrontSide, type Material, type Mesh, type Object3D, Vector3 } from 'three';
import { meshesOf } from '../../drawing/meshes.js';
import { ceilingOf } from '../mesh/openCeiling.js';
import type { PictureRange, PlainMesh } from '../mesh/PlainMesh.js';

/** The triangles of each mesh of a scene, in the order of `meshesOf`, that belong to a ceiling: 1 for each of them, else 0. */
export type SceneCeiling = readonly Uint8Array[];

const cornersOf = ({ geometry: { index, attributes } }: Mesh): number =>
  index?.count ?? attributes.position?.count ?? 0;

/** Whether a mesh is drawn once, at rest, and with whole triangles. */
const isPlain = (mesh: Mesh): boolean =>
  !('isSkinnedMesh' in mesh || 'isInstancedMesh' in mesh || mesh.morphTargetInfluences) && cornersOf(mesh) % 3 === 0;

/**
 * Finds the ceiling of the closed rooms of a scene that does not move, y up, as `openCeiling` does for a mesh.
 *
 * @returns undefined if there is none to leave out, or if meshes are repeated or deformed
 */
export function findSceneCeiling(root: Object3D): SceneCeiling | undefined {
  const meshes = meshesOf(root);
  if (!meshes.every(isPlain)) return undefined;
  const ceiling = ceilingOf(joinedMesh(root, meshes), 'y');
  if (!ceiling) return undefined;
  let end = 0;
  return meshes.map((mesh) => {
    const first = end;
    end += cornersOf(mesh) / 3;
    return ceiling.subarray(first, end);
  });
}

/** Leaves out the triangles of a ceiling, and the meshes that have no others. */
export function leaveOutCeiling(root: Object3D, ceiling: SceneCeiling): void {
  for (const [i, mesh] of meshesOf(root).entries()) {
    if (!ceiling[i].includes(1)) continue;
    // Other meshes may have the same geometry.
    mesh.geometry = mesh.geometry.clone();
    const { geometry } = mesh;
    const { index } = geometry;
    const kept: number[] = [];
    for (let corner = 0; corner < cornersOf(mesh); corner++)
      if (ceiling[i][Math.floor(corner / 3)] === 0) kept.push(index ? index.getX(corner) : corner);
    if (kept.length === 0) mesh.removeFromParent();
    else geometry.setIndex(new BufferAttribute(Uint32Array.from(kept), 1));
  }
}

const isSeeThrough = ({ transparent, transmission = 0 }: Material & { transmission?: number }): boolean =>
  transparent || transmission > 0;

/** The triangles of all meshes in the space of the scene, each mesh a part of its own. A mirroring matrix reverses triangles. */
function joinedMesh(root: Object3D, meshes: readonly Mesh[]): PlainMesh {
  root.updateWorldMatrix(true, true);
  const positions = new Float32Array(3 * meshes.reduce((sum, mesh) => sum + cornersOf(mesh), 0));
  const ofVertices = new Uint32Array(positions.length / 3);
  const ranges: PictureRange[] = [];
  const point = new Vector3();
  let start = 0;
  for (const [part, mesh] of meshes.entries()) {
    const { index, attributes } = mesh.geometry;
    const order = mesh.matrixWorld.determinant() < 0 ? [0, 2, 1] : [0, 1, 2];
    const count = cornersOf(mesh);
    for (let corner = 0; corner < count; corner++) {
      const at = corner - (corner % 3) + order[corner % 3];
      point
        .fromBufferAttribute(attributes.position, index ? index.getX(at) : at)
        .applyMatrix4(mesh.matrixWorld)
        .toArray(positions, 3 * (start + corner));
    }
    ofVertices.fill(part, start, start + count);
    const materials = [mesh.material].flat();
    const isOneSided = materials.every(({ side }) => side === FrontSide);
    ranges.push({ start, count, picture: -1, isOneSided, isSeeThrough: materials.some(isSeeThrough) });
    start += count;
  }
  const names = meshes.map(({ name }) => name);
  return { positions, normals: null, colors: null, indices: null, ranges, parts: { names, ofVertices } };
}
