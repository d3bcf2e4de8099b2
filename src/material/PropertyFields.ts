import { ShaderMaterial } from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_DEFAULTS, HATCHING_PROPERTIES, type HatchingPropertyName } from '../look/hatchingProperties.js';
import type { Hand } from '../strokes/hand/Hand.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';
import { accessorOf, fieldOf } from './propertyAccessors.js';
import type { HatchingMap } from './propertyValues.js';

/**
 * The properties of `HatchingMaterial` as fields, defined from the property table. Colours, vectors and textures are plain fields; the
 * values of all others are checked when set. Subclasses define what setting a choice does.
 */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: the constructor defines every property of the table.
export abstract class PropertyFields extends ShaderMaterial {
  protected chosenMap: HatchingMap = HATCHING_DEFAULTS.tonalArtMap;
  protected chosenHand: Hand | null = null;
  /**
   * The numbers that were set; the others have the technique's defaults. They are in a Map, because V8 allocates a number whenever it
   * is read from a field by a computed name, which here would be every frame.
   */
  protected numbers = new Map<HatchingPropertyName, number | 'auto' | 'fit' | null>();

  constructor() {
    super();
    for (const key in HATCHING_PROPERTIES) this.define(key as HatchingPropertyName);
  }

  /** The value of a choice that is in effect. */
  protected abstract choice(name: HatchingPropertyName): string | boolean;

  /** @throws Error if `value` is none of the property's choices */
  protected abstract choose(name: HatchingPropertyName, value: string | boolean): void;

  /** Copies the numbers that were set, so that the others keep following the technique. */
  protected copyNumbers({ numbers }: PropertyFields): void {
    this.numbers = new Map(numbers);
  }

  private define(name: HatchingPropertyName): void {
    const { owner }: HatchingProperty = HATCHING_PROPERTIES[name];
    if (owner !== undefined) return;
    const field = fieldOf(name);
    // All materials have the same accessors, except that of the tone curve, which the material defines.
    if (field !== undefined) Object.assign(this, { [name]: field });
    else if (!(name in this)) Object.defineProperty(PropertyFields.prototype, name, accessorOf(name));
  }
}

export interface PropertyFields extends HatchingMaterialProperties {}
