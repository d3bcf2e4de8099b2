// The tonal art map: RGBA layers that overlap by one tone, so that both hatch images of any tone lie in one texel and a triangle costs one
// fetch (written by src/material/tam/TonalArtMapTexture.ts).

uniform highp sampler2DArray tonalArtMap;
uniform float tonalArtMapTones;
uniform float tonalArtMapLastLayer;

// The lightness of the hatch at uv, ∈ [0, 1]: two neighbouring hatch images interpolated by tone or, for hard bands as in `toon`, the
// nearest one. To be called in uniform control flow, since derivatives of uv may choose the level.
float lightnessOfHatch(const in vec2 uv, const in float tone) {
  float x = tone * (tonalArtMapTones - 1.0);
  #if TONE_MODEL == TONE_MODEL_TOON
    x = floor(x + 0.5);
  #endif // TONE_MODEL
  float layer = min(floor(x / 3.0), tonalArtMapLastLayer);
  // The position between each image and the next; one of the three lies within (0, 1).
  vec3 steps = clamp(x - 3.0 * layer - vec3(0.0, 1.0, 2.0), 0.0, 1.0);
  vec4 images = readImages(tonalArtMap, vec3(uv, layer));
  return images.r + dot(images.gba - images.rgb, steps);
}
