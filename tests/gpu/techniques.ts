import { HATCHING_TECHNIQUES, type HatchingTechnique } from '../../src/material/hatchingProperties.js';

/** Every technique, for what all of them must do. */
export const techniques = Object.keys(HATCHING_TECHNIQUES) as HatchingTechnique[];

/** Those that shade fragments by themselves, and one for those that shade triangles with their neighbours. */
export const kindsOfTechnique = ['adjacency', 'anchored', 'engraved'] as const;
