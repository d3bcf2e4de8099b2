import type { Material, Mesh, Object3D } from 'three';

/** Which meshes a scene has, in order, and how they look: what has to stay as it is for a hatched scene to stay hatched. */
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

  /** Whether a mesh came or went, or was given another geometry or material. Allocates nothing. */
  differs(root: Object3D): boolean {
    return this.compare(root, 0) !== this.meshes.length;
  }

  /** Whether a mesh is new, or looks otherwise. */
  looksOtherwise(mesh: Mesh): boolean {
    const place = this.meshes.indexOf(mesh);
    return place < 0 || mesh.geometry !== this.geometries[place] || mesh.material !== this.materials[place];
  }

  /** Whether there are the same meshes, whatever they look like. */
  hasMeshesOf(root: Object3D): boolean {
    const meshes = meshesOf(root);
    return meshes.length === this.meshes.length && meshes.every((mesh, i) => mesh === this.meshes[i]);
  }

  /** Compares what is at or below an object with the meshes from `place` on. The place after them; NaN where they differ. */
  private compare(object: Object3D, place: number): number {
    let next = place;
    if (isMesh(object)) {
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

/** Every mesh at or below an object. */
export function meshesOf(root: Object3D): Mesh[] {
  return root.getObjectsByProperty('isMesh', true) as Mesh[];
}

const isMesh = (object: Object3D): object is Mesh => 'isMesh' in object;
