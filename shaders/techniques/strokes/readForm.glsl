// Strokes along or across the level lines of a baked function. Across seams of the bake its sign may change, and with it those of both
// axes: the map looks the same then.
#include "perFragment/fullShadow"

// n: unit normal, object space.
void readStrokeAxes(const in vec3 n, inout HatchingParameters h) {
  vec3 along = cross(n, vFormSlope);
  float squaredLength = dot(along, along);
  // At a singular point of the field any direction will do.
  along = squaredLength > 0.0 ? along * inversesqrt(squaredLength) : normalize(anyTangent(n));
  bool isAcross = DIRECTION == DIRECTION_ACROSS_FORM;
  #ifdef REORIENTS_IN_SHADOW
    // Strokes run the other way where no light arrives.
    if (isInFullShadow()) isAcross = !isAcross;
  #endif // REORIENTS_IN_SHADOW
  h.uAxis = isAcross ? cross(n, along) : along;
  h.vAxis = cross(n, h.uAxis);
  h.crossing = 0.0;
}
