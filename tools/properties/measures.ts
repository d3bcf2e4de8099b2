/** What a number measures. */
export interface Measure {
  /** For JSDoc and documentation. */
  words: string;
  /** Whether it grows with a picture that has more pixels. */
  isInPixels?: true;
}

export const MEASURES = {
  pixels: { words: 'pixels of the drawing buffer', isInPixels: true },
  /** Of the grid of pixels itself, however large the picture. */
  gridPixels: { words: 'pixels' },
  radians: { words: 'radians' },
  tiles: { words: 'tiles' },
  tileParts: { words: '256ths of a tile' },
  tilesPerUnit: { words: 'tiles of the tonal art map per unit of object space' },
} as const satisfies Record<string, Measure>;

export type MeasureName = keyof typeof MEASURES;

/** The measure of a number, in words. */
export function measureWords(measure: MeasureName, onScreen?: MeasureName): string {
  const { words } = MEASURES[measure];
  return onScreen ? `${MEASURES[onScreen].words} at a \`screenConstancy\` of 1, ${words} at 0` : words;
}

/** Whether a number is in pixels: always, or as far as `screenConstancy` says; undefined if never. */
export function pixelsOf(measure?: MeasureName, onScreen?: MeasureName): 'always' | 'onScreen' | undefined {
  const isInPixels = (name?: MeasureName): boolean => name !== undefined && 'isInPixels' in MEASURES[name];
  if (isInPixels(measure)) return 'always';
  return isInPixels(onScreen) ? 'onScreen' : undefined;
}
