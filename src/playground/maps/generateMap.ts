import { TonalArtMap } from 'three-hatching';

/** Generates a map. A module of its own, so that a drawing without a map does not load it. */
export const generateMap: typeof TonalArtMap.generate = (options) => TonalArtMap.generate(options);
