import { BITMAPS, type Surroundings } from '../../viewer/files/common/Surroundings.js';

/** The platform functions for reading models on a page or in its worker. Draco's decoder is fetched when it is first needed. */
export const PAGE_SURROUNDINGS: Surroundings = {
  ...BITMAPS,
  loadDraco: async () => (await import('./loadDraco.js')).loadDraco(),
};
