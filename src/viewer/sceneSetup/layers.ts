/** The layers of a saved picture, bottom first. */
export const LAYERS = ['colour', 'shadow', 'strokes', 'outline'] as const;
export type Layer = (typeof LAYERS)[number];
