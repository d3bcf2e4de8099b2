import { Color, ShaderMaterial, Vector2, type Vector3 } from 'three';
import { checkNumber } from './checkNumber.js';
import { checkHatchingMap, type HatchingMap } from './checkTonalArtMap.js';
import { checkPoint, isWord } from './checkValues.js';
import type { SceneExtent } from './emphasis/SceneExtent.js';
import { defaultOf } from './facts/defaultOf.js';
import type { HatchingProperty } from './facts/HatchingProperty.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  type HatchingPropertyName,
  type HatchingTechnique,
} from './facts/hatchingProperties.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';
import { toPoint } from './vectorValues.js';

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
  private focused: Vector3 | null = null;
  private hatchImages: HatchingMap = HATCHING_DEFAULTS.tonalArtMap;
  /**
   * Numbers that were set. The others follow the technique. In a map, because V8 allocates a number that is read from a field whose name
   * is not known beforehand, in every frame.
   */
  private numbers = new Map<HatchingPropertyName, number | 'auto' | null>();

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
    else if (!(name in this)) Object.defineProperty(PropertyFields.prototype, name, PropertyFields.accessorOf(name));
  }

  private static accessorOf(name: HatchingPropertyName): PropertyDescriptor & ThisType<PropertyFields> {
    const property: HatchingProperty = HATCHING_PROPERTIES[name];
    if (property.kind === 'tonalArtMap')
      return {
        get() {
          return this.hatchImages;
        },
        set(value) {
          this.hatchImages = checkHatchingMap(value);
        },
      };
    if (property.kind === 'point')
      return {
        get() {
          return this.focused;
        },
        set(value) {
          checkPoint(name, value);
          this.focused = value === null ? null : toPoint(value);
        },
      };
    if (property.kind === 'number') {
      const defaults = new Map<HatchingTechnique, unknown>();
      return {
        get() {
          const set = this.numbers.get(name);
          if (set !== undefined && set !== null) return set;
          const { technique } = this;
          if (!defaults.has(technique)) defaults.set(technique, defaultOf(name, technique));
          return defaults.get(technique);
        },
        set(value) {
          this.numbers.set(name, isWord(name, value) ? value : checkNumber(name, value, property.range));
        },
      };
    }
    return {
      get() {
        return this.choice(name);
      },
      set(value) {
        this.choose(name, value);
      },
    };
  }
}

export interface PropertyFields extends HatchingMaterialProperties {}

/** A new value for a plain field; undefined for other properties. */
function fieldOf(name: HatchingPropertyName): unknown {
  switch (HATCHING_PROPERTIES[name].kind) {
    case 'color':
      return new Color(HATCHING_DEFAULTS[name] as number);
    case 'vector2':
      return new Vector2(...(HATCHING_DEFAULTS[name] as readonly [number, number]));
    case 'texture':
      return null;
    default:
      return undefined;
  }
}
