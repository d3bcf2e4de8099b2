// How far the lines of a family lie apart.
uniform float lineSpacing; // pixels between lines, or 256ths of a tile
#if TONE_MODEL == TONE_MODEL_SHADOW
  uniform float shadowSpacing; // factor on lineSpacing in shadows
  #define WANTED_SPACING (shadowSpacing * lineSpacing)
#else
  #define WANTED_SPACING lineSpacing
#endif // TONE_MODEL
uniform float minLineSpacing; // pixels: where lines would lie closer, every other one is left out, so that they do not shimmer

// Width over which the edge of a line fades, pixels.
#define FRINGE 0.5

// An approximate logarithm to base 2: exact at powers of two, linear between them, which continuous octaves need. x: above 0.
float octaves(const in float x) {
  // The bits of a float are its exponent and 23 bits of its mantissa.
  return float(floatBitsToInt(x)) * (1.0 / 8388608.0) - 127.0;
}

// The inverse of `octaves`.
float powerOf2(const in float octave) {
  return intBitsToFloat(int(octave * 8388608.0 + 1065353216.0));
}

// The change of a family's function from one pixel to the next on the flat triangle, above 0.
float trianglePerPixelOf(const in Family family) {
  return max(family.trianglePerPixel, max(LEAST_OF_SMOOTH * family.perPixel, 1e-12));
}

// The octave of the distance between its lines, before repeats of their numbers limit it.
float octaveOf(const in Family family, const in float trianglePerPixel) {
  // Smooth normals space lines evenly over the triangles of a round body; on coarse meshes they may be far off.
  float perPixel = clamp(family.perPixel, trianglePerPixel / MOST_OFF_TRIANGLE, trianglePerPixel * MOST_OFF_TRIANGLE);
  float onObject = octaves(WANTED_SPACING / PARTS_OF_TILE * family.rise);
  float onScreen = octaves(WANTED_SPACING * perPixel);
  return max(mix(onObject, onScreen, screenSpaceShare), octaves(minLineSpacing * perPixel));
}
