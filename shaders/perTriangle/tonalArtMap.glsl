// The tonal art map: RGBA layers that overlap by one tone, so that both hatch images of any tone lie in one texel and
// a triangle costs one fetch (src/material/tam/packHatchImages.ts writes them).

uniform highp sampler2DArray tonalArtMap;
uniform float tonalArtMapTones;
uniform float tonalArtMapLastLayer;

// How light the hatch is at uv, ∈ [0, 1]: the two neighbouring hatch images interpolated by tone or, for bands as hard as
// those of `toon`, the nearest one. Call it in uniform control flow: derivatives of uv may choose the level.
float lightnessOfHatch(const in vec2 uv, const in float tone) {
  float x = tone * (tonalArtMapTones - 1.0);
  #if TONE_MODEL == TONE_MODEL_TOON
    x = floor(x + 0.5);
  #endif // TONE_MODEL
  float layer = min(floor(x / 3.0), tonalArtMapLastLayer);
  // How far from each image on to the next; of the three, one lies within (0, 1).
  vec3 steps = clamp(x - 3.0 * layer - vec3(0.0, 1.0, 2.0), 0.0, 1.0);
  vec4 images = readImages(tonalArtMap, vec3(uv, layer));
  return images.r + dot(images.gba - images.rgb, steps);
}
