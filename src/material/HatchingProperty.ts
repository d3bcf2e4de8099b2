/** What the material needs to know of a property at run time. */
export type HatchingProperty = HatchingValue | HatchingTexture | HatchingChoice | HatchingSwitch | HatchingOther;

/** What the material brings to the shader in a way of its own. */
export interface HatchingOther extends UsedByTechniques {
  kind: 'tonalArtMap' | 'curve';
}

interface UsedByTechniques {
  /** The techniques it counts for. Left out: all. */
  techniques?: readonly string[];
}

/** A value that the shader reads from a uniform. */
export interface HatchingValue extends UsedByTechniques {
  kind: 'number' | 'color' | 'vector2';
  /** Left out where other uniforms are computed from the value. */
  uniform?: string;
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
  define: string;
  choices: readonly string[];
  /** Techniques with another default. */
  defaultFor?: Readonly<Record<string, string>>;
}

/** On or off. The shader knows it as a define that is there or not. */
export interface HatchingSwitch extends UsedByTechniques {
  kind: 'switch';
  define: string;
}
