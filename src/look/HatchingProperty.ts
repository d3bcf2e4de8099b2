/** What the material needs to know of a property at run time. */
export type HatchingProperty =
  | HatchingNumber
  | HatchingValue
  | HatchingTexture
  | HatchingChoice
  | HatchingSwitch
  | HatchingOther;

/** What the material brings to the shader in a way of its own. */
export interface HatchingOther extends UsedByTechniques {
  kind: 'tonalArtMap' | 'curve' | 'point';
  /** What the tonal art map counts with, as in `HatchingFacts`: without the map there is nothing to draw. */
  when?: HatchingCondition;
  /** The default under a technique that has another. */
  defaultFor?: Readonly<Record<string, string>>;
}

/** What every property has. */
export interface UsedByTechniques {
  /** Colours as 0xrrggbb, vectors as arrays. */
  default: unknown;
  /** The techniques that read it. Left out: all. */
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
  /** Whether `'auto'` may be in its place beside a default that is a number. */
  isAuto?: true;
  /** The default under a technique that has another. */
  defaultFor?: Readonly<Record<string, number>>;
}

/** Above a bound or from it on, and up to another. */
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

/** One of several names. The shader knows it as a define whose value is the name's place in `choices`. */
export interface HatchingChoice extends UsedByTechniques {
  kind: 'choice';
  /** Left out for the technique: it chooses the shaders themselves. */
  define?: string;
  choices: readonly string[];
  /** The choices that a technique knows, where these are not all; another one counts as the default. */
  choicesFor?: Readonly<Record<string, readonly string[]>>;
  /** The default under each technique, where it depends on that; `'auto'` asks for it again. */
  defaultFor?: Readonly<Record<string, string>>;
}

/** On or off. The shader knows it as a define that is there or not. */
export interface HatchingSwitch extends UsedByTechniques {
  kind: 'switch';
  define: string;
}

/** What the material needs to know of a technique; all else lies in its folder of chunks, shaders/techniques/<name>. */
export interface HatchingTechniqueData {
  /** What it asks of a geometry's vertices: the primitive of six, or a normal at the scale of a stroke. */
  vertexData: 'adjacency' | 'hatchNormal';
  /** The texture it reads, unless the material is crisp: that takes thresholds. */
  map: 'tonalArtMap' | 'thresholdMap' | 'none';
  /** Whether strokes that are sized on the object alone have a program of their own, which is cheaper. */
  hasProgramForObject: boolean;
}

/** What a property means beside what the shader reads. What is left out does not apply. */
export interface HatchingFacts {
  /** Of a number or a vector. */
  measure?: HatchingMeasure;
  /** What it measures at a `sizedOnScreen` of 1, where that is something else. In between it is a mean of the two. */
  measureOnScreen?: HatchingMeasure;
  /** What other properties must be for it to count. Several conditions: it is enough that one holds. */
  when?: HatchingCondition | readonly HatchingCondition[];
}

/**
 * Other properties, with the values of theirs that something counts with, or the one that it does not count with. All must
 * hold. A property that the technique does not read is not asked.
 */
export type HatchingCondition = Readonly<Record<string, readonly PlainValue[] | { readonly not: PlainValue }>>;

/** A value of a property as data has it. */
export type PlainValue = string | number | boolean | null;

/** What a number measures. */
export type HatchingMeasure =
  | 'pixels'
  | 'gridPixels'
  | 'radians'
  | 'tiles'
  | 'tileParts'
  | 'tilesPerUnit'
  | 'share'
  | 'depths'
  | 'worldUnits'
  | 'tone'
  | 'factor'
  | 'count'
  | 'exponent';

/** `toneModel` as `TONE_MODEL`. */
export const constantCase = (name: string): string => name.replace(/([A-Z])/g, '_$1').toUpperCase();
