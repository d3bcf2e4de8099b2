import type { Material, Mesh, Object3D } from 'three';
import { HatchingLineMaterial } from '../lines/HatchingLineMaterial.js';
import { scaledLineSizes } from '../lines/lineProperties.js';
import { scaledSizes } from '../material/facts/lookFacts.js';
import { HatchingMaterial } from '../material/HatchingMaterial.js';
import { materialsOf } from './surfaceMeshes.js';

type Sizes = Record<string, unknown>;

/** Multiplies all sizes in pixels of the hatching materials of a scene, and restores them. */
export class SizeScaler {
  private readonly scaled: { material: Sizes; name: string; own: unknown; value: unknown }[] = [];

  scale(root: Object3D, factor: number): void {
    this.restore();
    const materials = new Set<Material>();
    root.traverse((object) => {
      if ('material' in object) for (const material of materialsOf(object as Mesh)) materials.add(material);
    });
    for (const material of materials) {
      if (material instanceof HatchingMaterial) this.set(material, scaledSizes(material, factor));
      else if (material instanceof HatchingLineMaterial) this.set(material, scaledLineSizes(material, factor));
    }
  }

  /** Restores the sizes. A size that someone else has set in the meantime stays. */
  restore(): void {
    for (const { material, name, own, value } of this.scaled) {
      if (material[name] === value) material[name] = own;
    }
    this.scaled.length = 0;
  }

  /** Sets the sizes in the order of the table. If setting one clears another, the one that was set before remains set. */
  private set(material: HatchingMaterial | HatchingLineMaterial, sizes: Sizes): void {
    const values = material as unknown as Sizes;
    const changes = Object.entries(sizes).map(([name, value]) => ({
      material: values,
      name,
      own: values[name],
      value,
    }));
    this.scaled.push(...changes);
    Object.assign(values, sizes);
  }
}
