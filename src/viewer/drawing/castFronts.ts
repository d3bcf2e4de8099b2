import { FrontSide, type Material, type Mesh, type Object3D, Vector3 } from 'three';
import { openTriangles } from '../../mesh/orientation/openTriangles.js';
import type { TriangleMesh } from '../../mesh/TriangleMesh.js';
import type { Slices } from '../files/common/Slices.js';
import { meshesOf } from './meshes.js';

const isOneSided = ({ material }: Mesh): boolean => [material].flat().some(({ side }) => side === FrontSide);

/**
 * Finds the one-sided meshes of a scene that are open or face inward, as they are before skins and morph targets deform them. A body may
 * consist of several meshes. Materials that such a mesh shares with others become its own.
 */
export async function openMeshes(root: Object3D, slices: Slices): Promise<Mesh[]> {
  const meshes = meshesOf(root).filter(isWhole);
  if (!meshes.some(isOneSided)) return [];
  root.updateWorldMatrix(true, true);
  const joined = await joinedMesh(meshes, slices);
  const task = openTriangles(joined);
  let step = task.next();
  for (; !step.done; step = task.next()) await slices.next();
  let first = 0;
  const open = meshes.filter((mesh) => {
    const before = first;
    first += cornersOf(mesh) / 3;
    return isOneSided(mesh) && step.done && (step.value as Uint8Array).subarray(before, first).includes(1);
  });
  separateMaterials(meshes, open);
  return open;
}

/** Makes shadows of one-sided surfaces those of their fronts, which are seen; by default three.js takes those of the backs. */
export function castFronts(meshes: readonly Mesh[]): void {
  for (const { material } of meshes)
    for (const one of [material].flat()) if (one.side === FrontSide) one.shadowSide = FrontSide;
}

const cornersOf = ({ geometry: { index, attributes } }: Mesh): number => index?.count ?? attributes.position.count;

/** Whether a mesh has triangles, and only valid ones. */
function isWhole(mesh: Mesh): boolean {
  const { index, attributes } = mesh.geometry;
  const { position } = attributes;
  if (!position || cornersOf(mesh) === 0 || cornersOf(mesh) % 3 !== 0) return false;
  for (let corner = 0; index && corner < index.count; corner++) if (index.getX(corner) >= position.count) return false;
  return true;
}

/** The triangles of all meshes in the world. A mirroring matrix reverses them. */
async function joinedMesh(meshes: readonly Mesh[], slices: Slices): Promise<TriangleMesh> {
  const positions = new Float32Array(
    3 * meshes.reduce((sum, { geometry }) => sum + geometry.attributes.position.count, 0),
  );
  const indices = new Uint32Array(meshes.reduce((sum, mesh) => sum + cornersOf(mesh), 0));
  const point = new Vector3();
  let vertex = 0;
  let corner = 0;
  for (const mesh of meshes) {
    const { index, attributes } = mesh.geometry;
    const order = mesh.matrixWorld.determinant() < 0 ? [0, 2, 1] : [0, 1, 2];
    const first = corner;
    for (; corner < first + cornersOf(mesh); corner++) {
      const at = corner - first - ((corner - first) % 3) + order[(corner - first) % 3];
      indices[corner] = vertex + (index ? index.getX(at) : at);
    }
    for (let i = 0; i < attributes.position.count; i++, vertex++)
      point
        .fromBufferAttribute(attributes.position, i)
        .applyMatrix4(mesh.matrixWorld)
        .toArray(positions, 3 * vertex);
    await slices.next();
  }
  return { positions, indices };
}

/** Gives meshes copies of the materials that they share with others. */
function separateMaterials(meshes: readonly Mesh[], own: readonly Mesh[]): void {
  const isOwn = new Set(own);
  const others = new Set(meshes.filter((mesh) => !isOwn.has(mesh)).flatMap(({ material }) => [material].flat()));
  const copies = new Map<Material, Material>();
  const copyOf = (material: Material): Material => {
    if (!others.has(material)) return material;
    const copy = copies.get(material) ?? material.clone();
    copies.set(material, copy);
    return copy;
  };
  for (const mesh of own)
    mesh.material = Array.isArray(mesh.material) ? mesh.material.map(copyOf) : copyOf(mesh.material);
}
