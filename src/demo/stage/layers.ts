/** The layers that a picture comes apart in, the lowest first: what is under the ink, then the ink. */
export const LAYERS = ['colour', 'shadow', 'strokes', 'outline'] as const;
export type Layer = (typeof LAYERS)[number];
