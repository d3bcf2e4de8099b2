import { BITMAPS } from '../../viewer/files/common/bitmaps.js';
import type { Surroundings } from '../../viewer/files/common/Surroundings.js';

/** What a page or its worker reads models with. Draco's decoder is fetched for the first part that is packed with it. */
export const PAGE_SURROUNDINGS: Surroundings = {
  ...BITMAPS,
  loadDraco: async () => (await import('./loadDraco.js')).loadDraco(),
};
