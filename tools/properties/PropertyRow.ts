import type { NumberRange } from '../../src/material/HatchingProperty.js';
import type { MeasureName } from './measures.js';

/** A property of the material: one row of the table. What is left out does not apply. */
export type PropertyRow = NumberRow | ColorRow | Vector2Row | TextureRow | MapRow | ChoiceRow | SwitchRow | CurveRow;

export type PropertyGroup = 'Strokes' | 'Medium' | 'Tone' | 'Surface' | 'Colour' | 'Checking';

interface BaseRow {
  group: PropertyGroup;
  /** What it is, for JSDoc and documentation; Markdown. Unit, range, default and techniques are added to it. */
  sentence: string;
  /** The techniques it counts for. Left out: all. */
  techniques?: readonly string[];
  /** Other properties, and their values that it counts for. One that does not count itself is not asked. */
  when?: Readonly<Record<string, readonly (string | boolean)[]>>;
}

/** A uniform of the same name, unless `uniform` says otherwise; `false` where other uniforms are computed from it. */
export interface NumberRow extends BaseRow {
  kind: 'number';
  /** `null`: no number is asked for, and null may be set. */
  default: number | null;
  /** Another number that gives way when this one is set. */
  clears?: string;
  /** How the default is written where digits would hide what it is. */
  defaultSource?: string;
  /** Left out: a share, a factor or a count. */
  measure?: MeasureName;
  /** What it measures at a `screenConstancy` of 1, where that is something else. In between it is a mean of the two. */
  measureOnScreen?: MeasureName;
  /** Left out: every finite number. */
  range?: NumberRange;
  uniform?: false;
}

/** A colour; any of three's representations is taken. */
export interface ColorRow extends BaseRow {
  kind: 'color';
  default: number;
  defaultWords: string;
  /** Default: the property's name. */
  uniform?: string;
}

/** A uniform of the same name, unless `uniform` is `false`: then others are computed from it. */
export interface Vector2Row extends BaseRow {
  kind: 'vector2';
  default: readonly [number, number];
  measure?: MeasureName;
  uniform?: false;
}

/** A texture with its transform: the uniforms `name` and `nameTransform`. */
export interface TextureRow extends BaseRow {
  kind: 'texture';
  default: null;
}

export interface MapRow extends BaseRow {
  kind: 'tonalArtMap';
  default: null;
}

/** One of several names: a define, so another choice builds another program. */
export interface ChoiceRow extends BaseRow {
  kind: 'choice';
  /** The exported type of the names, and what it is. */
  type: string;
  typeSentence: string;
  /** Every name and what it means; the order is the number the shader knows it by. */
  choices: Readonly<Record<string, string>>;
  default: string;
  /** The default under each technique, where it depends on that; `'auto'` asks for it again. */
  defaultFor?: Readonly<Record<string, string>>;
  /** Choices that draw without a map, with every technique that they count for. */
  withoutMap?: readonly string[];
  /** `false` for the technique: it chooses the shaders themselves. */
  isDefine?: false;
}

/** On or off: a define, so switching builds another program. */
export interface SwitchRow extends BaseRow {
  kind: 'switch';
  default: false;
}

/** `toneCurve`, which is a name or points. */
export interface CurveRow extends BaseRow {
  kind: 'curve';
  default: 'linear';
}
