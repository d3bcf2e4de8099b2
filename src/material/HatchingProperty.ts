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
  kind: 'tonalArtMap' | 'curve';
}

interface UsedByTechniques {
  /** The techniques it counts for. Left out: all. */
  techniques?: readonly string[];
  /** Other properties, and their values that it counts for. One that does not count itself is not asked. */
  when?: Readonly<Record<string, readonly (string | boolean)[]>>;
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
  /** Whether it is measured in pixels: always, or as far as `screenConstancy` says. Left out: never. */
  pixels?: 'always' | 'onScreen';
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
  /** Choices that draw without a map, with every technique that they count for. */
  withoutMap?: readonly string[];
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
}
