import { ShaderMaterial, type Vector3 } from 'three';
import { HATCHING_DEFAULTS, HATCHING_PROPERTIES, type HatchingPropertyName } from '../look/hatchingProperties.js';
import type { HatchingMap } from './checkTonalArtMap.js';
import type { SceneExtent } from './fading/SceneExtent.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';
import { accessorOf, fieldOf } from './propertyAccessors.js';

/**
 * The properties of `HatchingMaterial` as fields, after the table: colours, vectors and textures are plain fields, and what is set to the
 * others is checked. What setting a choice does is up to the material.
 */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: the constructor defines every property of the table.
export abstract class PropertyFields extends ShaderMaterial {
  /**
   * How far the scene reaches, by which `depthFade` measures depth; `applyHatching` sets it. Without one its units are those of the world,
   * from the eye. Default: null.
   */
  extent: SceneExtent | null = null;
  protected focused: Vector3 | null = null;
  protected hatchImages: HatchingMap = HATCHING_DEFAULTS.tonalArtMap;
  /**
   * Numbers that were set. The others follow the technique. In a map, because V8 allocates a number that is read from a field whose name
   * is not known beforehand, in every frame.
   */
  protected numbers = new Map<HatchingPropertyName, number | 'auto' | null>();

  constructor() {
    super();
    for (const key in HATCHING_PROPERTIES) this.define(key as HatchingPropertyName);
  }

  /** The choice in force. */
  protected abstract choice(name: HatchingPropertyName): string | boolean;

  /** @throws Error if `value` is none of the property's choices */
  protected abstract choose(name: HatchingPropertyName, value: string | boolean): void;

  /** Numbers that were never set stay so. The extent is that of the same scene. */
  protected copyNumbers({ numbers, focused, extent }: PropertyFields): void {
    this.numbers = new Map(numbers);
    this.focused = focused?.clone() ?? null;
    this.extent = extent;
  }

  private define(name: HatchingPropertyName): void {
    const field = fieldOf(name);
    // Accessors are the same for all materials; that of the tone curve is the material's own.
    if (field !== undefined) Object.assign(this, { [name]: field });
    else if (!(name in this)) Object.defineProperty(PropertyFields.prototype, name, accessorOf(name));
  }
}

export interface PropertyFields extends HatchingMaterialProperties {}
