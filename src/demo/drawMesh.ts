import { BufferAttribute, BufferGeometry, DoubleSide, FrontSide, Group, Mesh } from 'three';
import { HatchingMaterial, type HatchingStatistics, prepareHatchingGeometry } from 'three-hatching';
import { DrawnModel } from './DrawnModel.js';
import type { PlainMesh } from './PlainMesh.js';

/** Makes a drawing of one mesh; it is baked in the library's worker, normals it does not have are made there. */
export async function drawMesh(
  mesh: PlainMesh,
  options: { signal: AbortSignal; onProgress: (progress: number) => void },
): Promise<DrawnModel> {
  const source = new BufferGeometry();
  source.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  if (mesh.indices) source.setIndex(new BufferAttribute(mesh.indices, 1));
  if (mesh.normals) source.setAttribute('normal', new BufferAttribute(mesh.normals, 3));
  if (mesh.colors) source.setAttribute('color', new BufferAttribute(mesh.colors, 3));
  const geometry = await prepareHatchingGeometry(source, options);
  const facts = geometry.userData.hatching as HatchingStatistics;
  const material = new HatchingMaterial({
    strokeScale: 1,
    vertexColors: mesh.colors !== null,
    // An open surface shows its inside.
    side: facts.borderEdges > 0 || facts.nonManifoldEdges > 0 ? DoubleSide : FrontSide,
  });
  const root = new Group().add(new Mesh(geometry, material));
  return new DrawnModel(root, geometry.boundingBox!, facts, undefined, [material], () => {
    geometry.dispose();
    material.dispose();
  });
}
