uniform float tilesPerUnit; // tiles per object unit
uniform float texelPixels; // wanted pixels per texel

// The level of a map by the depth of the fragment alone (paper, section 3.4). size: texels per tile.
float levelByDepth(const in float size) {
  return log2(tilesPerUnit * vUnitsPerPixel * size * texelPixels);
}
