// The tone and the tint of the surface's own colour.
uniform float colorHatching; // share of its darkness that becomes tone
uniform float colorExposure; // factor on lightness, so that the lightest colours of the scene stay blank
uniform float colorFill; // share of it that is printed on the paper

// The darkness of a colour beside white, as far as it becomes tone. Emitted light lessens it.
float localDarkness(const in vec3 color, const in vec3 emitted) {
  if (colorHatching == 0.0) return 0.0;
  vec2 y = clamp(vec2(luminance(color), luminance(emitted)), 0.0, 1.0);
  return colorHatching * (1.0 - min(colorExposure * lightness(y.x), 1.0)) * (1.0 - y.y);
}

vec3 filledColor(const in vec3 color) {
  return mix(vec3(1.0), color, colorFill);
}
