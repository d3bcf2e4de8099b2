// What engraving needs to know at this fragment: the place, the normal, and the light of the field.
#include "technique/screenGradient"

uniform vec3 fieldCentre; // of the bounding sphere, object space

struct HatchingParameters {
  vec3 point; // from the centre of the object, object space
  vec3 normal; // unit, object space
  vec3 toLight; // unit, object space, the same all over the object; up to its sign with several lights
};

HatchingParameters readHatchingParameters() {
  return HatchingParameters(vRestPosition - fieldCentre, safeNormalize(vStrokeNormal), safeNormalize(vFieldLight));
}
