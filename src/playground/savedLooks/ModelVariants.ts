import type { BarItems } from './NamedBar.js';
import type { NamedItem } from './NamedList.js';

/** What shows variants of a model. */
interface VariantShower {
  readonly variants: readonly string[];
  /** The index of the one that is shown, if one was chosen. */
  readonly variant: number | undefined;
  showVariant(variant: number | undefined): void;
}

/** The variants of the materials of the model that is shown. */
export class ModelVariants implements BarItems {
  constructor(private readonly loader: VariantShower) {}

  get items(): readonly NamedItem[] {
    return this.loader.variants.map((name) => ({ name }));
  }

  /** Shows a variant; the one that is shown is given up for the materials that the file has without one. */
  choose(index: number): void {
    this.loader.showVariant(this.isShown(index) ? undefined : index);
  }

  isShown(index: number): boolean {
    return this.loader.variant === index;
  }
}
