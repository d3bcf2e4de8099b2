// What hatching needs to know at this fragment: the light's frame is found here, so that it turns continuously.
#include "lightOrientation"
#include "perFragment/viewToAnchor"

uniform vec2 strokeDirection; // cosine and sine of the strokes' rotation

struct HatchingParameters {
  vec3 point; // object space
  vec3 uAxis, vAxis; // the strokes' u and v in the surface, object space
  #if MEDIUM == MEDIUM_STIPPLE
    vec3 normal; // object space
  #else
    vec3 lean; // of u, v and the normal towards the viewer: proportional to their cosines
  #endif // MEDIUM
  float crossing; // how far the lights disagree
};

HatchingParameters readHatchingParameters() {
  HatchingParameters h;
  vec3 n = safeNormalize(vStrokeNormal);
  vec3 bitangent = lightBitangent(n, -vViewPosition, readViewToAnchor(), h.crossing);
  vec3 tangent = cross(bitangent, n);
  h.point = vRestPosition;
  h.uAxis = strokeDirection.x * tangent - strokeDirection.y * bitangent;
  h.vAxis = strokeDirection.y * tangent + strokeDirection.x * bitangent;
  #if MEDIUM == MEDIUM_STIPPLE
    h.normal = n;
  #else
    h.lean = vToViewer * mat3(h.uAxis, h.vAxis, n);
  #endif // MEDIUM
  return h;
}
