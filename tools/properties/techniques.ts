/** A way to lay strokes on a surface: one row, and a folder of chunks in shaders/techniques/ of the same name. */
export interface TechniqueRow {
  /** Its description for JSDoc and documentation, in Markdown. */
  sentence: string;
  /** The attributes that it requires: the primitive of six vertices, or a normal at the scale of a stroke. */
  vertexData: 'adjacency' | 'hatchNormal';
  /** The texture it reads, unless the material is crisp: that takes thresholds. */
  map: 'tonalArtMap' | 'thresholdMap' | 'none';
  /** Whether strokes that are sized on the object alone have a program of their own, which is cheaper. */
  hasProgramForObject: boolean;
  /** The normal tone is computed from where none is asked for. */
  toneNormal: 'face' | 'smooth';
}

export const TECHNIQUES = {
  triangle: {
    sentence:
      'Algorithm 1 alone. Every triangle has its own strokes; they break at its edges (paper by Suarez et al., figure 4a).',
    vertexData: 'adjacency',
    map: 'tonalArtMap',
    hasProgramForObject: false,
    toneNormal: 'face',
  },
  adjacency: {
    sentence: 'Algorithms 1 to 3. Every triangle blends in the strokes of its three neighbours (figure 4b).',
    vertexData: 'adjacency',
    map: 'tonalArtMap',
    hasProgramForObject: false,
    toneNormal: 'face',
  },
  anchored: {
    sentence:
      'goes beyond the paper by Suarez et al. Strokes are anchored to a lattice fixed on the object instead of to triangles, and ink is decided per pixel, after blending: continuous, crisp and independent of the mesh ([media.md](media.md#anchored-strokes)).',
    vertexData: 'hatchNormal',
    map: 'thresholdMap',
    hasProgramForObject: true,
    toneNormal: 'smooth',
  },
  engraved: {
    sentence:
      'goes beyond it too. Lines are level sets of a function on the object: they never break, swell with the tone and cross in the darks, as in an engraved plate. Draws without a map ([engraved.md](engraved.md)).',
    vertexData: 'hatchNormal',
    map: 'none',
    hasProgramForObject: false,
    toneNormal: 'smooth',
  },
} as const satisfies Record<string, TechniqueRow>;
