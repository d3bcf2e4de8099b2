// xyz: the normal smoothed to the scale of a stroke; zero where the geometry has none. w: the baked occlusion; 1 where the geometry has no
// such attribute, which is WebGL's default.
attribute vec4 hatchNormal;

// The occlusion of the front and of the back, as src/mesh/occlusion/occlusionSides.ts packs it: negative for one side, and for two sides
// a positive 16-bit integer.
vec2 occlusionOfSides(const in float w) {
  if (w <= 0.0) return vec2(-w);
  if (w >= 1.0) return vec2(0.0);
  float both = floor(32767.0 * w + 0.5);
  // Half a level is added, so that rounding of the quotient does not matter.
  float front = floor((both + 0.5) / SIDE_LEVELS);
  return vec2(front, both - SIDE_LEVELS * front) / (SIDE_LEVELS - 1.0);
}
