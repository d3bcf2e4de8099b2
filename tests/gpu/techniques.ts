import { HATCHING_TECHNIQUES, type HatchingTechnique } from '../../src/look/hatchingProperties.js';

/** Every technique, for what all of them must do. */
export const techniques = Object.keys(HATCHING_TECHNIQUES) as HatchingTechnique[];

/** The techniques that shade each fragment alone, and one of those that shade triangles with their neighbours. */
export const kindsOfTechnique = ['adjacency', 'anchored', 'engraved'] as const;
