import type { Mesh, Object3D } from 'three';
import type { HatchedScene, HatchingOutlines } from 'three-hatching';

/** Hides meshes for a while by taking them out of all layers. Properties that React sets, such as `visible`, stay as they are. */
export class Veil {
  private readonly masks = new Map<Object3D, number>();

  cover(object: Object3D): void {
    if (this.masks.has(object)) return;
    this.masks.set(object, object.layers.mask);
    object.layers.mask = 0;
  }

  /** Hides the outlines of a mesh whose geometry has changed. */
  coverOutlines({ children }: Mesh): void {
    for (const child of children) if ((child as Partial<HatchingOutlines>).isHatchingOutlines) this.cover(child);
  }

  /** Shows all meshes again, and puts their new outlines into the same layers. */
  lift(hatched: HatchedScene | undefined): void {
    for (const [mesh, mask] of this.masks) mesh.layers.mask = mask;
    for (const outlines of hatched?.outlines ?? []) {
      const mask = outlines.mesh && this.masks.get(outlines.mesh);
      if (typeof mask === 'number') outlines.layers.mask = mask;
    }
    this.masks.clear();
  }
}
