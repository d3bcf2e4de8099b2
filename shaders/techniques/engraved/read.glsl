// What engraving needs to know at this fragment: the place, the normal, and the direction of the field.
#include "technique/lightField"
#include "technique/screenGradient"

struct HatchingParameters {
  vec3 point; // from the centre of the object, object space
  vec3 normal; // unit, object space
  vec3 toLight; // unit, object space, the same all over the object: up to its sign, with several lights
};

HatchingParameters readHatchingParameters() {
  HatchingParameters h;
  h.point = vRestPosition - fieldCentre;
  h.normal = safeNormalize(vStrokeNormal);
  h.toLight = fieldLight();
  return h;
}
