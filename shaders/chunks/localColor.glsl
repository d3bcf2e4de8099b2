// What the surface's own colour gives to the picture: tone, and a tint below the strokes.
uniform float localTone; // how much of its darkness becomes tone
uniform float colorExposure; // what lightness is multiplied by, so that the lightest colours of the scene stay blank
uniform float colorFill; // how much of it is printed on the paper

// How much darker than white a colour looks, as far as that is to become tone. What gives off light itself does not look so dark.
float localDarkness(const in vec3 color, const in vec3 emitted) {
  if (localTone == 0.0) return 0.0;
  vec2 y = clamp(vec2(luminance(color), luminance(emitted)), 0.0, 1.0);
  return localTone * (1.0 - min(colorExposure * lightness(y.x), 1.0)) * (1.0 - y.y);
}

vec3 filledColor(const in vec3 color) {
  return mix(vec3(1.0), color, colorFill);
}
