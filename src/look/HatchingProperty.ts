/** A property as the material needs it at run time. */
export type HatchingProperty =
  | HatchingNumber
  | HatchingValue
  | HatchingTexture
  | HatchingChoice
  | HatchingSwitch
  | HatchingOther;

/** A property that the material passes to the shader in a way of its own. */
export interface HatchingOther extends UsedByTechniques {
  kind: 'tonalArtMap' | 'hand' | 'curve' | 'point';
  /** The default of families of techniques that have another. */
  defaultFor?: Readonly<Partial<Record<TechniqueFamily, string>>>;
}

/** An object that has properties of its own: one that a material has as a property, or a material that extends `HatchingMaterial`. */
export type HatchingOwner = 'composition' | 'perTriangle' | 'shadowMaterial';

/** Members of every property. */
export interface UsedByTechniques {
  /** Colours as 0xrrggbb, vectors as arrays. */
  default: unknown;
  /** The object that has it; left out: `HatchingMaterial` itself. */
  owner?: HatchingOwner;
  /** The techniques that read it. Default: all. */
  techniques?: readonly string[];
}

/** A value that the shader reads from a uniform. */
export interface HatchingValue extends UsedByTechniques {
  kind: 'color' | 'vector2';
  /** Left out where other uniforms are computed from the value. */
  uniform?: string;
}

/** A number; infinite ones and NaN are in no range. */
export interface HatchingNumber extends UsedByTechniques {
  kind: 'number';
  uniform?: string;
  range?: NumberRange;
  /** Words that are allowed beside a default that is a number. */
  words?: readonly string[];
  /** The default of families of techniques that have another. */
  defaultFor?: Readonly<Partial<Record<TechniqueFamily, number>>>;
}

/** A lower bound, included or not, and an optional upper one. */
export interface NumberRange {
  above?: number;
  from?: number;
  to?: number;
}

/** A texture, and the uniform of its transform. */
export interface HatchingTexture extends UsedByTechniques {
  kind: 'texture';
  uniform: string;
  transform: string;
}

/** One of several names. In the shader it is a define whose value is the index of the name in `choices`. */
export interface HatchingChoice extends UsedByTechniques {
  kind: 'choice';
  define: string;
  choices: readonly string[];
  /** The choices that a family of techniques knows, where these are not all. Any other counts as the default. */
  choicesFor?: Readonly<Partial<Record<TechniqueFamily, readonly string[]>>>;
  /** The default of families of techniques, where it depends on that; `'auto'` restores it. */
  defaultFor?: Readonly<Partial<Record<TechniqueFamily, string>>>;
}

/** On or off. In the shader it is a define that is set or not. */
export interface HatchingSwitch extends UsedByTechniques {
  kind: 'switch';
  define: string;
}

/**
 * The techniques that share shaders.
 * - `perTriangle`: strokes in the frames of triangles, which need triangle adjacency
 * - `strokes`: strokes or dots that are anchored to the object; those sized on the object alone have a cheaper program of their own
 * - `lines`: level sets of a function on the object
 */
export type TechniqueFamily = 'perTriangle' | 'strokes' | 'lines';

/** A technique as the material needs it. The rest lies in the chunks of its family, in shaders/techniques. */
export interface HatchingTechniqueData {
  family: TechniqueFamily;
  /** The texture it reads. A crisp material reads the threshold map instead. */
  map: 'tonalArtMap' | 'thresholdMap' | 'none';
}

/** Facts about a property that the shader does not need. Those left out do not apply. */
export interface HatchingFacts {
  /** The measure of a number or a vector. */
  measure?: HatchingMeasure;
  /** The measure at a `screenSpaceShare` of 1, if it differs. In between the value is a mean of the two. */
  measureOnScreen?: HatchingMeasure;
  /** The conditions under which the property counts. One that holds is enough. */
  when?: HatchingCondition | readonly HatchingCondition[];
}

/**
 * Conditions on other properties: the values with which something counts, or the one with which it does not. All must hold. Properties that
 * the technique does not read are ignored.
 */
export type HatchingCondition = Readonly<Record<string, readonly PlainValue[] | { readonly not: PlainValue }>>;

/** A value of a property as plain data. */
export type PlainValue = string | number | boolean | null;

/** The unit of a number. */
export type HatchingMeasure =
  | 'pixels'
  | 'gridPixels'
  | 'radians'
  | 'tiles'
  | 'tileParts'
  | 'tilesPerObjectUnit'
  | 'share'
  | 'depths'
  | 'worldUnits'
  | 'tone'
  | 'factor'
  | 'count'
  | 'exponent';

/** Converts `toneModel` to `TONE_MODEL`. */
export const constantCase = (name: string): string => name.replace(/([A-Z])/g, '_$1').toUpperCase();
