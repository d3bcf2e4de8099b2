// The tone and the tint of the surface's own colour.
uniform float colorHatching; // share of its darkness that becomes tone
uniform float colorExposure; // factor on lightness, so that the lightest colours of the scene stay blank
uniform vec4 colorFilter; // weights of red, green and blue in the lightness, and the share of the plan of values in the darkness
uniform vec4 valueKnots; // the plan of values: lightnesses at which the slope of the darkness changes
uniform vec4 valueBends; // by how much
uniform float mapBlur; // levels by which the map is read coarser for its tone than it is seen
uniform float colorFill; // share of it that is printed on the paper

// The darkness of a colour beside white, as far as it becomes tone. Emitted light lessens it.
float localDarkness(const in vec3 color, const in vec3 emitted) {
  if (colorHatching == 0.0) return 0.0;
  vec2 y = clamp(vec2(dot(colorFilter.rgb, color), luminance(emitted)), 0.0, 1.0);
  float light = lightness(y.x);
  float planned = dot(valueBends, max(valueKnots - light, 0.0));
  return colorHatching * mix(1.0 - min(colorExposure * light, 1.0), planned, colorFilter.a) * (1.0 - y.y);
}

// The colour that becomes tone: a map without details that are finer than strokes can show; where it is cut out, as it is.
// plain: the colour without the map.
vec3 tonedColor(const in vec3 plain, const in vec3 seen) {
  #if defined(USE_MAP) && !defined(DECODE_VIDEO_TEXTURE)
    if (mapBlur > 0.0) {
      vec4 coarse = texture2D(map, vMapUv, mapBlur);
      if (coarse.a >= OPAQUE_TEXEL) return plain * coarse.rgb;
    }
  #endif // USE_MAP
  return seen;
}

vec3 filledColor(const in vec3 color) {
  return mix(vec3(1.0), color, colorFill);
}
