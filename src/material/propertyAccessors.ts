import { Color, Vector2, type Vector3 } from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import {
  HATCHING_DEFAULTS,
  HATCHING_PROPERTIES,
  type HatchingPropertyName,
  type HatchingTechnique,
} from '../look/hatchingProperties.js';
import { defaultOf } from '../look/presetParameters.js';
import type { Hand } from '../strokes/hand/Hand.js';
import { checkHand, checkPoint, numberOrWord } from './checkProperty.js';
import { checkHatchingMap, type HatchingMap, toPoint } from './propertyValues.js';

/** The storage of a material's properties, for GLSL or nodes, or of a group of them. */
interface PropertyHolder {
  /** Left out by holders whose defaults do not depend on it. */
  readonly technique?: HatchingTechnique;
  focused: Vector3 | null;
  chosenMap: HatchingMap;
  chosenHand: Hand | null;
  readonly numbers: Map<HatchingPropertyName, number | 'auto' | 'fit' | null>;
  choice(name: HatchingPropertyName): string | boolean;
  choose(name: HatchingPropertyName, value: string | boolean): void;
}

/** The getter and setter of a property that is not a plain field, for the prototype of its owner. The setter checks the value. */
export function accessorOf(name: HatchingPropertyName): PropertyDescriptor & ThisType<PropertyHolder> {
  const property: HatchingProperty = HATCHING_PROPERTIES[name];
  if (property.kind === 'tonalArtMap')
    return {
      get() {
        return this.chosenMap;
      },
      set(value) {
        this.chosenMap = checkHatchingMap(value);
      },
    };
  if (property.kind === 'hand')
    return {
      get() {
        return this.chosenHand;
      },
      set(value) {
        checkHand(value);
        this.chosenHand = value;
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
    const defaults = new Map<HatchingTechnique | undefined, unknown>();
    return {
      get() {
        const set = this.numbers.get(name);
        if (set !== undefined && set !== null) return set;
        const { technique } = this;
        if (!defaults.has(technique)) defaults.set(technique, defaultOf(name, technique));
        return defaults.get(technique);
      },
      set(value) {
        this.numbers.set(name, numberOrWord(name, value, property));
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

/** An initial value for a property that is a plain field; undefined for other properties. */
export function fieldOf(name: HatchingPropertyName): unknown {
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
