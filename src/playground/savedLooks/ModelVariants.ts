import type { BarItems } from './NamedBar.js';
import type { NamedItem } from './NamedList.js';

/** Shows variants of a model. */
interface VariantShower {
  readonly variants: readonly string[];
  /** Index of the shown variant, if one was chosen. */
  readonly variant: number | undefined;
  showVariant(variant: number | undefined): void;
}

/** The material variants of the shown model. */
export class ModelVariants implements BarItems {
  constructor(private readonly loader: VariantShower) {}

  get items(): readonly NamedItem[] {
    return this.loader.variants.map((name) => ({ name }));
  }

  /** Shows a variant; choosing the shown one again returns to the file's default materials. */
  choose(index: number): void {
    this.loader.showVariant(this.isShown(index) ? undefined : index);
  }

  isShown(index: number): boolean {
    return this.loader.variant === index;
  }
}
