// The parameters of engraving at this fragment: the functions whose level sets are lines, and their derivatives on the screen.
#include "perFragment/viewToAnchor"

uniform mat3 objectToField; // linear part

#include "technique/hand"
#include "perFragment/screenGradient"

// The Jacobian of the map from pixels to positions on a surface, in the field; limited at grazing angles. It is turned by a right angle.
// normal: of any length.
mat2x3 surfaceOnScreen(const in vec3 normal) {
  mat3 viewToAnchor = readViewToAnchor();
  vec3 right = objectToField * viewToAnchor[0];
  vec3 up = objectToField * viewToAnchor[1];
  // The ray, its depth 1: the last coordinate is 1 over the depth, and 1 for orthographic cameras.
  vec3 ray = gl_FragCoord.w * vRay;
  vec2 centre = isOrthographic ? vec2(0.0) : gl_FragCoord.w * vViewPosition.xy;
  vec2 across = vec2(dot(normal, right), dot(normal, up));
  float facing = dot(normal, ray);
  float least = LEAST_FACING * length(vec3(across, facing - dot(centre, across)));
  float scale = vViewUnitsPerPixel / max(max(abs(facing), least), 1e-20);
  return mat2x3(scale * (across.y * ray - facing * up), scale * (facing * right - across.x * ray));
}

mat2x3 smoothOnScreen() {
  return surfaceOnScreen(vFieldNormal);
}

// The flat triangle is mapped by its normal, since differences of positions are inexact where triangles are smaller than pixels.
mat2x3 triangleOnScreen() {
  return surfaceOnScreen(cross(dFdx(vFieldPoint), dFdy(vFieldPoint)));
}

// Lines that are level sets of one function.
struct Family {
  float value;
  float perPixel; // change from one pixel to the next, on the smooth surface
  float trianglePerPixel; // the same on the flat triangle
  float rise; // change along the surface, per tile, by which lines are spaced on the object
  vec3 gradient; // of any length; lines lie across it
  float coarsest; // octave of the widest spacing of its lines
};

#ifdef FOLLOWS_FORM
  #include "technique/readForm"
#else
  #include "technique/readCut"
#endif // FOLLOWS_FORM
