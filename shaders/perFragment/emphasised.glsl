#include "emphasis"

// The weight of the drawing at this fragment, which is noted before anything asks for it.
float emphasis = 1.0;

void noteEmphasis() {
  emphasis = emphasisAt(-vViewPosition, gl_FragCoord.xy);
}

// What is left of a tone.
PerToneNormal emphasised(const in PerToneNormal tone) {
  return emphasis * tone;
}

// The colour of the surface fades towards the paper too.
vec3 emphasisedColor(const in vec3 color) {
  return mix(vec3(1.0), color, emphasis);
}
