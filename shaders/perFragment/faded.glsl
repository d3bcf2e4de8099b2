#include "fading"

// The share of ink that fading leaves at this fragment, set before it is read.
float fading = 1.0;

void computeFading() {
  fading = fadingAt(-vViewPosition, gl_FragCoord.xy);
}

// A tone, faded.
PerToneNormal faded(const in PerToneNormal tone) {
  return fading * tone;
}

// The colour of the surface fades towards the paper too.
vec3 fadedColor(const in vec3 color) {
  return mix(vec3(1.0), color, fading);
}
