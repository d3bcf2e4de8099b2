uniform float tilesPerObjectUnit; // tiles per object unit
uniform float texelPixels; // desired pixels per texel

// The level of a map for the depth of the fragment (paper, section 3.4). size: texels per tile.
float levelByDepth(const in float size) {
  return log2(tilesPerObjectUnit * vUnitsPerPixel * size * texelPixels);
}
