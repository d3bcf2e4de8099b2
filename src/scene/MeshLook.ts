import type { BufferGeometry, Material, Mesh } from 'three';

/** The geometry and material of a mesh, and the coordinate frame of its engraved lines. */
export interface MeshLook {
  mesh: Mesh;
  geometry: BufferGeometry;
  material: Material | Material[];
  /** The matrix from the mesh's object space to the coordinate frame of its engraved lines, if it shares that frame with others. */
  fieldFrame: number[] | undefined;
}
