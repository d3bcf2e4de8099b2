import type {
  HatchingCondition,
  HatchingMeasure,
  HatchingOwner,
  NumberRange,
  TechniqueFamily,
} from '../../src/look/HatchingProperty.js';
import type { StrokeStyleName } from '../../src/strokes/strokeStyleNames.js';

/** A property of the material: one row of the table. What is left out does not apply. */
export type PropertyRow =
  | NumberRow
  | ColorRow
  | Vector2Row
  | PointRow
  | TextureRow
  | MapRow
  | HandRow
  | ChoiceRow
  | SwitchRow
  | CurveRow;

export type PropertyGroup =
  | 'Strokes'
  | 'Dry media'
  | 'Tone'
  | 'Surface'
  | 'Colour'
  | 'Checking'
  | 'Composition'
  | 'Per triangle'
  | 'Shadows on a ground';

interface BaseRow {
  group: PropertyGroup;
  /** The object that has it; left out: `HatchingMaterial` itself. */
  owner?: HatchingOwner;
  /** Its description for JSDoc and documentation, in Markdown. Unit, range, default and techniques are added. */
  sentence: string;
  /** The techniques that read it. Left out: all. */
  techniques?: readonly string[];
  /** Conditions on other properties, one of which must hold for it to have an effect. */
  when?: HatchingCondition | readonly HatchingCondition[];
}

/** A uniform of the same name, unless `uniform` says otherwise; `false` where other uniforms are computed from it. */
export interface NumberRow extends BaseRow {
  kind: 'number';
  /** `null`: no number is asked for, and null may be set. `'auto'`: the material finds one, and `'auto'` may be set. */
  default: number | null | 'auto';
  /** The default of families of techniques that have another. */
  defaultFor?: Readonly<Partial<Record<TechniqueFamily, number>>>;
  /** The default as an expression, where digits would be obscure. */
  defaultSource?: string;
  measure: HatchingMeasure;
  /** Its unit at a `screenSpaceShare` of 1, if another. In between it is a mean of the two. */
  measureOnScreen?: HatchingMeasure;
  /** Left out: every finite number. */
  range?: NumberRange;
  /** Words that may be in its place beside a default that is a number. */
  words?: readonly ('auto' | 'fit')[];
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
  measure: HatchingMeasure;
  uniform?: false;
}

/** A point in the scene, or null. Uniforms are computed from it. */
export interface PointRow extends BaseRow {
  kind: 'point';
  default: null;
  measure: HatchingMeasure;
}

/** A texture with its transform: the uniforms `name` and `nameTransform`. */
export interface TextureRow extends BaseRow {
  kind: 'texture';
  default: null;
}

export interface MapRow extends BaseRow {
  kind: 'tonalArtMap';
  /** The style of the shared map. */
  default: StrokeStyleName;
}

/** A hand, or null. Uniforms are computed from it. */
export interface HandRow extends BaseRow {
  kind: 'hand';
  default: null;
}

/** A choice of several names: a define, so that another choice builds another program. */
export interface ChoiceRow extends BaseRow {
  kind: 'choice';
  /** The exported type of the names, and what it is. */
  type: string;
  typeSentence: string;
  /** Every name and what it means; the order is the number the shader knows it by. */
  choices: Readonly<Record<string, string>>;
  default: string;
  /** The default of families of techniques, where it depends on that; `'auto'` asks for it again. */
  defaultFor?: Readonly<Partial<Record<TechniqueFamily, string>>>;
  /** The choices that a family of techniques knows, where these are not all; another one counts as the default. */
  choicesFor?: Readonly<Partial<Record<TechniqueFamily, readonly string[]>>>;
}

/** A switch: a define, so that changing it builds another program. */
export interface SwitchRow extends BaseRow {
  kind: 'switch';
  default: false;
}

/** `toneCurve`, which is a name or points. */
export interface CurveRow extends BaseRow {
  kind: 'curve';
  default: 'linear';
  /** The default of families of techniques that have another. */
  defaultFor?: Readonly<Partial<Record<TechniqueFamily, 'printed'>>>;
}
