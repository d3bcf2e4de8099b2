/** Parameters of glass: a few light strokes at a slant where light turns to shade, and nothing that hides what is behind it. */
export const GLASS = {
  transparent: true,
  opacity: 1,
  depthWrite: false,
  paperOpacity: 0.5,
  direction: 'slant',
  toneCurve: [
    [0, 0],
    [0.45, 0],
    [0.6, 0.12],
    [0.75, 0],
    [1, 0],
  ],
  colorHatching: 0,
  occlusion: 0,
} as const;

/** The opacity of the paper of glass that lets through `transmission` of the light. A woodcut has black and paper alone, so its glass is clear. */
export const paperOfGlass = (technique: string, transmission = 1): number =>
  technique === 'woodcut' ? 0 : 1 - (1 - GLASS.paperOpacity) * transmission;
