import type { HatchingMeasure } from '../../src/look/HatchingProperty.js';

/** Units of numbers, in words for JSDoc and documentation. */
const WORDS: Readonly<Record<HatchingMeasure, string>> = {
  pixels: 'CSS pixels',
  // Pixels of the grid, whatever the size of the picture.
  gridPixels: 'pixels of the drawing buffer',
  radians: 'radians',
  tiles: 'tiles',
  tileParts: '256ths of a tile',
  tilesPerObjectUnit: 'tiles of the tonal art map per unit of object space',
  share: 'share',
  depths: 'depths of the scene',
  worldUnits: 'units of the world',
  tone: 'tone',
  factor: 'factor',
  count: 'count',
  exponent: 'exponent',
};

/** The measure of a number, in words. */
export function measureWords(measure: HatchingMeasure, onScreen?: HatchingMeasure): string {
  return onScreen ? `${WORDS[onScreen]} at a \`screenSpaceShare\` of 1, ${WORDS[measure]} at 0` : WORDS[measure];
}
