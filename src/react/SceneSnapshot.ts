import type { Material, Mesh, Object3D } from 'three';
import { leftAlone } from 'three-hatching/facts';

/** A record of the meshes to hatch in a scene, in order, with their geometries and materials, which shows when the scene changes. */
export class SceneSnapshot {
  private readonly meshes: Mesh[] = [];
  private readonly geometries: Mesh['geometry'][] = [];
  private readonly materials: (Material | Material[])[] = [];

  take(root: Object3D): void {
    this.meshes.length = 0;
    this.geometries.length = 0;
    this.materials.length = 0;
    for (const object of meshesOf(root)) {
      this.meshes.push(object);
      this.geometries.push(object.geometry);
      this.materials.push(object.material);
    }
  }

  /** Whether a mesh was added or removed, or has another geometry or material. Allocates nothing. */
  differs(root: Object3D): boolean {
    return this.compare(root, 0) !== this.meshes.length;
  }

  /** Records the present geometries of meshes, whose change was intended. */
  takeGeometries(meshes: readonly Mesh[]): void {
    for (const mesh of meshes) {
      const place = this.meshes.indexOf(mesh);
      if (place >= 0) this.geometries[place] = mesh.geometry;
    }
  }

  /** Whether a mesh is new, or has another geometry or material. */
  looksOtherwise(mesh: Mesh): boolean {
    const place = this.meshes.indexOf(mesh);
    return place < 0 || mesh.geometry !== this.geometries[place] || mesh.material !== this.materials[place];
  }

  /** Whether the scene has the same meshes, whatever their geometries and materials. */
  hasMeshesOf(root: Object3D): boolean {
    const meshes = meshesOf(root);
    return meshes.length === this.meshes.length && meshes.every((mesh, i) => mesh === this.meshes[i]);
  }

  /**
   * Compares the meshes at or below an object with those recorded from `place` on. Returns the place after them, or NaN if they differ.
   */
  private compare(object: Object3D, place: number): number {
    let next = place;
    if (isHatched(object)) {
      const isKnown =
        object === this.meshes[place] &&
        object.geometry === this.geometries[place] &&
        object.material === this.materials[place];
      if (!isKnown) return Number.NaN;
      next++;
    }
    for (const child of object.children) next = this.compare(child, next);
    return next;
  }
}

/** All meshes at or below an object that are to be hatched. Helpers, which are left alone, may change freely. */
export function meshesOf(root: Object3D): Mesh[] {
  return (root.getObjectsByProperty('isMesh', true) as Mesh[]).filter(isHatched);
}

const isHatched = (object: Object3D): object is Mesh => 'isMesh' in object && leftAlone(object as Mesh) === undefined;
