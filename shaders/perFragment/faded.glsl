#include "fading"

// The share of ink that fading leaves at this fragment, set before it is read.
float fading = 1.0;

void computeFading() {
  #ifdef FADES_AROUND
    fading = fadingAt(-vViewPosition, gl_FragCoord.xy);
  #else
    fading = importance * (1.0 - depthFading.z * airBefore(-vViewPosition));
  #endif // FADES_AROUND
}

// A tone, faded.
PerToneNormal faded(const in PerToneNormal tone) {
  return fading * tone;
}

// The colour of the surface fades towards the paper too.
vec3 fadedColor(const in vec3 color) {
  return mix(vec3(1.0), color, fading);
}
