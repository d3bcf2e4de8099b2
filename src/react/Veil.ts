import type { Mesh, Object3D } from 'three';
import type { HatchedScene, HatchingLines } from 'three-hatching';

/** Keeps meshes from being drawn for a while, without touching what React sets: meanwhile they are in no layer. */
export class Veil {
  private readonly masks = new Map<Object3D, number>();

  cover(object: Object3D): void {
    if (this.masks.has(object)) return;
    this.masks.set(object, object.layers.mask);
    object.layers.mask = 0;
  }

  /** Lines of another geometry than the one that a mesh has now. */
  coverLines({ children }: Mesh): void {
    for (const child of children) if ((child as Partial<HatchingLines>).isHatchingLines) this.cover(child);
  }

  /** Shows all again, and their lines, which were made to be in the same layers. */
  lift(hatched: HatchedScene | undefined): void {
    for (const [mesh, mask] of this.masks) mesh.layers.mask = mask;
    for (const lines of hatched?.lines ?? []) {
      const mask = lines.mesh && this.masks.get(lines.mesh);
      if (typeof mask === 'number') lines.layers.mask = mask;
    }
    this.masks.clear();
  }
}
