// The rule for the level of the map. size: texels per tile of the map.
#if LEVEL_RULE == LEVEL_RULE_DEPTH
  #include "levelByDepth"

  vec4 readImages(const in highp sampler2DArray map, const in vec3 place) {
    return textureLod(map, place, levelByDepth(float(textureSize(map, 0).x)));
  }

  // Octaves by which the map would be too fine at a fragment.
  float minification(const in vec2 uv, const in float size) {
    return levelByDepth(size);
  }

  // Octaves by which strokes of a level are finer than drawn.
  float crowdingOf(const in vec2 uv, const in float size, const in float level) {
    vec2 texels = size * vec2(dFdx(uv.y), dFdy(uv.y)); // per pixel, across the strokes
    return 0.5 * log2(dot(texels, texels)) - level;
  }
#else
  uniform float texelPixels; // desired pixels per texel

  vec4 readImages(const in highp sampler2DArray map, const in vec3 place) {
    return texture(map, place);
  }

  float minification(const in vec2 uv, const in float size) {
    return log2(size * texelPixels * max(length(dFdx(uv)), length(dFdy(uv))));
  }

  float crowdingOf(const in vec2 uv, const in float size, const in float level) {
    return 0.0; // the level prevents crowding
  }
#endif // LEVEL_RULE
