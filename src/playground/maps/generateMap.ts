import { TonalArtMap } from 'three-hatching';

/** Draws a map. In a module of its own, so that a drawing without a map does not fetch the code. */
export const generateMap: typeof TonalArtMap.generate = (options) => TonalArtMap.generate(options);
