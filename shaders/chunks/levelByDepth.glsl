uniform float strokeScale; // tiles per object unit
uniform float texelPixels; // wanted pixels per texel

// The level of a map of so many texels per tile by the depth of the fragment alone (paper, section 3.4).
float levelByDepth(const in float size) {
  return log2(strokeScale * vUnitsPerPixel * size * texelPixels);
}
