import type { Material, Mesh, Object3D } from 'three';
import { HatchingLineMaterial } from '../lines/HatchingLineMaterial.js';
import { HatchingMaterial } from '../material/HatchingMaterial.js';
import { LINE_SIZES, STROKE_SIZES } from './pixelSizes.js';
import { materialsOf } from './surfaceMeshes.js';

type SizeName = (typeof STROKE_SIZES)[number] | (typeof LINE_SIZES)[number];
type Sizes = Partial<Record<SizeName, number | null>>;

/** Multiplies what the hatching materials of a scene measure in pixels, and takes it back. */
export class SizeScaler {
  private readonly scaled: { sizes: Sizes; name: SizeName; own: number; value: number }[] = [];

  scale(root: Object3D, factor: number): void {
    this.restore();
    const materials = new Set<Material>();
    root.traverse((object) => {
      if ('material' in object) for (const material of materialsOf(object as Mesh)) materials.add(material);
    });
    for (const material of materials) {
      if (material instanceof HatchingMaterial) this.scaleAll(material, strokeSizes(material), factor);
      else if (material instanceof HatchingLineMaterial) this.scaleAll(material, LINE_SIZES, factor);
    }
  }

  /** A size that was set meanwhile stays as it was set. */
  restore(): void {
    for (const { sizes, name, own, value } of this.scaled) {
      if (sizes[name] === value) sizes[name] = own;
    }
    this.scaled.length = 0;
  }

  private scaleAll(sizes: Sizes, names: readonly SizeName[], factor: number): void {
    for (const name of names) {
      const own = sizes[name];
      // Those of zero need no factor, and null stands for another one.
      if (!own) continue;
      const value = own * factor;
      sizes[name] = value;
      this.scaled.push({ sizes, name, own, value });
    }
  }
}

const strokeSizes = ({ strokeWidth, screenConstancy }: HatchingMaterial): SizeName[] =>
  STROKE_SIZES.filter(
    (name) =>
      // Setting one of the two clears the other.
      !(name === 'texelPixels' && strokeWidth !== null) &&
      // On the object it is measured in tiles.
      !(name === 'lineSpacing' && screenConstancy === 0),
  );
