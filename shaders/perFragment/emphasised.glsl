#include "emphasis"

// The weight of the drawing at this fragment, set before it is read.
float emphasis = 1.0;

void noteEmphasis() {
  emphasis = emphasisAt(-vViewPosition, gl_FragCoord.xy);
}

// A tone times the weight of the drawing.
PerToneNormal emphasised(const in PerToneNormal tone) {
  return emphasis * tone;
}

// The colour of the surface fades towards the paper too.
vec3 emphasisedColor(const in vec3 color) {
  return mix(vec3(1.0), color, emphasis);
}
