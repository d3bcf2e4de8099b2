import type { TechniqueFamily } from '../../src/look/HatchingProperty.js';

/** A way to draw a surface: one row. Its family has the shaders, in shaders/techniques. */
export interface TechniqueRow {
  /** Its description for JSDoc and documentation, in Markdown. */
  sentence: string;
  family: TechniqueFamily;
  /** The texture it reads, unless the ink is sharp: that takes thresholds. */
  map: 'tonalArtMap' | 'thresholdMap' | 'none';
}

export const TECHNIQUES = {
  triangle: {
    sentence:
      'Algorithm 1 alone. Every triangle has its own strokes; they break at its edges (paper by Suarez et al., figure 4a).',
    family: 'perTriangle',
    map: 'tonalArtMap',
  },
  adjacency: {
    sentence: 'Algorithms 1 to 3. Every triangle blends in the strokes of its three neighbours (figure 4b).',
    family: 'perTriangle',
    map: 'tonalArtMap',
  },
  hatching: {
    sentence:
      'strokes of a tonal art map in ink. They are anchored to a lattice fixed on the object, and ink is decided per pixel, after blending: continuous, crisp and independent of the mesh ([media.md](media.md#anchored-strokes)).',
    family: 'strokes',
    map: 'thresholdMap',
  },
  dryMedia: {
    sentence:
      'the same strokes in pencil, charcoal or chalk: a grey that grows with the pressure and catches on the grain of the paper, which lies on the screen ([media.md](media.md#pencil-charcoal-chalk)).',
    family: 'strokes',
    map: 'thresholdMap',
  },
  stipple: {
    sentence:
      'dots in the place of strokes, fixed on the surface and round on the screen. `strokeWidth` is the diameter of a dot at half tone; from a tone of 0.95 on they leave no paper. Draws without a map ([media.md](media.md#stipple)).',
    family: 'strokes',
    map: 'none',
  },
  engraving: {
    sentence:
      'lines that are level sets of a function on the object: they never break, swell with the tone and cross in the darks, as in an engraved plate. Draws without a map ([engraving.md](engraving.md)).',
    family: 'lines',
    map: 'none',
  },
  pen: {
    sentence:
      'the same lines in strokes of a pen, which begin and end thin, and are fewer in the lights ([media.md](media.md#pen)).',
    family: 'lines',
    map: 'none',
  },
  woodcut: {
    sentence:
      'the same lines cut white out of black: wedges that widen with the light and end in points ([media.md](media.md#woodcut)).',
    family: 'lines',
    map: 'none',
  },
} as const satisfies Record<string, TechniqueRow>;

export type TechniqueName = keyof typeof TECHNIQUES;
