/** The layers that a picture can be saved in, the lowest first: what lies under the ink, then the ink. */
export const LAYERS = ['colour', 'shadow', 'strokes', 'outline'] as const;
export type Layer = (typeof LAYERS)[number];
