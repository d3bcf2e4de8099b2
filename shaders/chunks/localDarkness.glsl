uniform float colorHatching; // share of the darkness of the surface's own colour that becomes tone
uniform float colorExposure; // factor on lightness, so that the lightest colours of the scene stay blank
uniform vec4 colorFilter; // weights of red, green and blue in the lightness, and the share of the plan of values in the darkness
uniform vec4 valueKnots; // the plan of values: lightnesses at which the slope of the darkness changes
uniform vec4 valueBends; // by how much

// The darkness of a colour beside white, as far as it becomes tone. Emitted light lessens it.
float localDarkness(const in vec3 color, const in vec3 emitted) {
  if (colorHatching == 0.0) return 0.0;
  vec2 y = clamp(vec2(dot(colorFilter.rgb, color), dot(emitted, vec3(0.2126, 0.7152, 0.0722))), 0.0, 1.0);
  float light = lightness(y.x);
  float planned = dot(valueBends, max(valueKnots - light, 0.0));
  return colorHatching * mix(1.0 - min(colorExposure * light, 1.0), planned, colorFilter.a) * (1.0 - y.y);
}
