import { TonalArtMap } from 'three-hatching';

/** Draws a map. Apart from the cache, so that a drawing without a map does not fetch what draws one. */
export const generateMap: typeof TonalArtMap.generate = (options) => TonalArtMap.generate(options);
