#include "emphasis"

// What is left of a tone.
PerToneNormal emphasised(const in PerToneNormal tone) {
  return emphasisAt(-vViewPosition, gl_FragCoord.xy) * tone;
}

// The colour of the surface fades towards the paper too.
vec3 emphasisedColor(const in vec3 color) {
  return mix(vec3(1.0), color, emphasisAt(-vViewPosition, gl_FragCoord.xy));
}
