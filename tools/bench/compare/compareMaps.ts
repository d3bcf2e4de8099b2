import type { TonalArtMapOptions } from 'three-hatching';
import { alternate, type Effort, type Times } from './alternate.js';
import { loadLibraries } from './loadLibraries.js';

/** Time of `TonalArtMap.generate` in both libraries, in their workers. */
export async function compareMaps(options: TonalArtMapOptions, effort: Effort): Promise<Times> {
  const libraries = await loadLibraries();
  return alternate(effort, async (side) => {
    const start = performance.now();
    await libraries[side].TonalArtMap.generate(options);
    return performance.now() - start;
  });
}
