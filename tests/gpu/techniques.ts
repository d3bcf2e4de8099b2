import type { HatchingTechnique } from '../../src/look/hatchingProperties.js';

/** One technique of each folder of shaders, for what all of them must do. */
export const techniques = ['triangle', 'adjacency', 'hatching', 'engraving'] as const satisfies HatchingTechnique[];

/** The techniques that shade each fragment alone, and one of those that shade triangles with their neighbours. */
export const kindsOfTechnique = ['adjacency', 'hatching', 'engraving'] as const;
