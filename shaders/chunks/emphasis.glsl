// How much weight the drawing has at a place: 1 as usual, 0 none.
uniform vec3 depthFading; // the depths from which and up to which it fades, view units; how strongly
uniform vec4 focusing; // the point in focus, view space, and its radius; 0 without one
uniform float vignette; // how much falls off towards the rim
uniform vec4 sheet; // its lower left corner from that of what is drawn to, and its size, pixels
uniform float importance; // of the object

// How much air lies before a place: 0 in front, 1 at the back.
float airBefore(const in vec3 viewPosition) {
  if (depthFading.z == 0.0) return 0.0;
  float way = clamp((-viewPosition.z - depthFading.x) / (depthFading.y - depthFading.x), 0.0, 1.0);
  return (1.0 - exp(-AIR * way)) / (1.0 - exp(-AIR));
}

// An edge that is left open by hand: waves whose phases bend one another, in [-UNEVEN, UNEVEN]. The numbers mean nothing.
float uneven(const in vec3 p) {
  float a = sin(dot(p, vec3(4.3, 3.1, -3.7)) + 1.6 * sin(dot(p, vec3(-2.9, 5.3, 4.1))));
  float b = sin(dot(p, vec3(-11.0, 13.0, 9.0)) + 1.3 * sin(dot(p, vec3(7.0, -5.0, 6.0))) + 2.0);
  return UNEVEN * (0.65 * a + 0.35 * b);
}

float inFocus(const in vec3 viewPosition) {
  if (focusing.w == 0.0) return 1.0;
  // Turned to the world, the edge stays where it is as the camera moves.
  vec3 away = (viewPosition - focusing.xyz) * mat3(viewMatrix) / focusing.w;
  return 1.0 - smoothstep(1.0, FOCUS_END, length(away) * (1.0 + uneven(away)));
}

float onSheet(const in vec2 pixel) {
  if (vignette == 0.0) return 1.0;
  vec2 away = 2.0 * (pixel - sheet.xy) / sheet.zw - 1.0;
  return 1.0 - vignette * smoothstep(VIGNETTE_START, 1.0, length(away) * (1.0 + uneven(vec3(2.0 * away, 0.0))));
}

// A factor on the tone. pixel: of what is drawn to.
float emphasisAt(const in vec3 viewPosition, const in vec2 pixel) {
  return importance * inFocus(viewPosition) * onSheet(pixel) * (1.0 - depthFading.z * airBefore(viewPosition));
}

// A factor on the width of outlines.
float outlineEmphasisAt(const in vec3 viewPosition, const in vec2 pixel) {
  return emphasisAt(viewPosition, pixel) * (1.0 + FRONT_GAIN * depthFading.z * (1.0 - airBefore(viewPosition)));
}

float mostOutlineEmphasis() {
  return 1.0 + FRONT_GAIN * depthFading.z;
}
