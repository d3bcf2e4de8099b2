import type { Mesh, Object3D } from 'three';

/** Hides meshes for a while by taking them out of all layers. Properties that React sets, such as `visible`, stay as they are. */
export class Veil {
  private readonly masks = new Map<Object3D, number>();

  cover(object: Object3D): void {
    if (this.masks.has(object)) return;
    this.masks.set(object, object.layers.mask);
    object.layers.mask = 0;
  }

  /** Hides the outlines of a mesh whose geometry has changed. Those of a mesh that is hidden are hidden with it. */
  coverOutlines({ children }: Mesh): void {
    for (const child of children) if (isOutlines(child) && child.layers.mask !== 0) this.cover(child);
  }

  /** Shows all meshes again, and then their outlines, which follow their layers. */
  lift(): void {
    for (const isLater of [false, true])
      for (const [object, mask] of this.masks) if (isOutlines(object) === isLater) object.layers.mask = mask;
    this.masks.clear();
  }
}

const isOutlines = (object: Object3D): boolean => 'isHatchingOutlines' in object;
