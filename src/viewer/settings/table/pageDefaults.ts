/**
 * The settings whose default is not the library's, in the units of the page. All others that stand for a property of the library have its
 * default.
 */
export const PAGE_DEFAULTS = {
  ink: '#1c1a17',
  paper: '#f7f3e8',
  // Strokes lie on the object, as in the paper by Suarez et al., and cross where lights do.
  screenSpaceShare: 0,
  tilesPerObjectUnit: 2.5,
  strokeLayers: 'lights',
  // As lines cross; strokes do so in deeper shade.
  crossFrom: 52,
  outlineHand: 0.5,
  // Files have parts that run into one another; a scene made in code is known to its author.
  outlineMeetings: 'on',
  // The tone is that of the light, under lights that anybody may turn up.
  toneCurve: 'linear',
  exposure: 'auto',
  reflectedLight: 43,
  lightStrength: 115,
  // Baking takes seconds, so that it waits until it is asked for.
  occlusion: 0,
  hollowStrength: 0,
  focusRadius: 0.5,
} as const;
