// The share of ink that fading leaves at a place: 1 where nothing fades.
uniform vec3 depthFading; // depths at which fading begins and ends, view units; its strength
uniform vec4 focusing; // point in focus, view space, and its radius; radius 0 for none
uniform float vignette; // strength of the falloff towards the rim
uniform vec4 sheet; // lower left corner in the render target, and size, pixels
uniform float importance; // of the object

// Strength of aerial perspective: 0 in front, 1 at the back.
float airBefore(const in vec3 viewPosition) {
  if (depthFading.z == 0.0) return 0.0;
  float way = clamp((-viewPosition.z - depthFading.x) / (depthFading.y - depthFading.x), 0.0, 1.0);
  return (1.0 - exp(-AIR * way)) / (1.0 - exp(-AIR));
}

// The irregularity of a hand-drawn edge, in [-UNEVEN, UNEVEN]: sines whose phases vary with one another. The numbers are arbitrary.
float uneven(const in vec3 p) {
  float a = sin(dot(p, vec3(4.3, 3.1, -3.7)) + 1.6 * sin(dot(p, vec3(-2.9, 5.3, 4.1))));
  float b = sin(dot(p, vec3(-11.0, 13.0, 9.0)) + 1.3 * sin(dot(p, vec3(7.0, -5.0, 6.0))) + 2.0);
  return UNEVEN * (0.65 * a + 0.35 * b);
}

float inFocus(const in vec3 viewPosition) {
  if (focusing.w == 0.0) return 1.0;
  // In world space the edge stays in place as the camera moves.
  vec3 away = (viewPosition - focusing.xyz) * mat3(viewMatrix) / focusing.w;
  return 1.0 - smoothstep(1.0, FOCUS_END, length(away) * (1.0 + uneven(away)));
}

float onSheet(const in vec2 pixel) {
  if (vignette == 0.0) return 1.0;
  vec2 away = 2.0 * (pixel - sheet.xy) / sheet.zw - 1.0;
  return 1.0 - vignette * smoothstep(VIGNETTE_START, 1.0, length(away) * (1.0 + uneven(vec3(2.0 * away, 0.0))));
}

// A factor on the tone. pixel: of the render target.
float fadingAt(const in vec3 viewPosition, const in vec2 pixel) {
  return importance * inFocus(viewPosition) * onSheet(pixel) * (1.0 - depthFading.z * airBefore(viewPosition));
}

// A factor on the width of outlines.
float outlineFadingAt(const in vec3 viewPosition, const in vec2 pixel) {
  return fadingAt(viewPosition, pixel) * (1.0 + FRONT_GAIN * depthFading.z * (1.0 - airBefore(viewPosition)));
}

float mostOutlineFading() {
  return 1.0 + FRONT_GAIN * depthFading.z;
}
