// What engraving needs to know at this fragment: the place, the normal, and the light of the field.
#include "technique/screenGradient"

struct HatchingParameters {
  vec3 point; // from the origin of the field, tiles
  vec3 normal; // unit, field space
  vec3 toLight; // unit, field space, the same all over the object; up to its sign with several lights
  float bend; // one over the distance of the lamp, 0 for light from without an end
};

HatchingParameters readHatchingParameters() {
  return HatchingParameters(vFieldPoint, safeNormalize(vFieldNormal), vFieldLight.xyz, vFieldLight.w);
}
