// The parameters of engraving at this fragment: the functions whose level sets are lines, and their derivatives on the screen.
#include "perFragment/viewToAnchor"

uniform mat3 objectToField; // linear part

#include "technique/hand"
#include "perFragment/screenGradient"

// The Jacobian of the map from pixels to positions on the smooth surface, in the field. It is turned by a right angle.
mat2x3 smoothOnScreen() {
  mat3 viewToAnchor = readViewToAnchor();
  vec3 right = objectToField * viewToAnchor[0];
  vec3 up = objectToField * viewToAnchor[1];
  // The ray, its depth 1: the last coordinate is 1 over the depth, and 1 for orthographic cameras.
  vec3 ray = gl_FragCoord.w * vRay;
  vec2 centre = isOrthographic ? vec2(0.0) : gl_FragCoord.w * vViewPosition.xy;
  vec2 normal = vec2(dot(vFieldNormal, right), dot(vFieldNormal, up));
  float facing = dot(vFieldNormal, ray);
  float least = LEAST_FACING * length(vec3(normal, facing - dot(centre, normal)));
  float scale = vViewUnitsPerPixel / max(max(abs(facing), least), 1e-20);
  return mat2x3(scale * (normal.y * ray - facing * up), scale * (facing * right - normal.x * ray));
}

// The same for the flat triangle. Over the depth, positions are linear on the screen, so that differences of neighbours are exact.
mat2x3 triangleOnScreen() {
  vec4 place = gl_FragCoord.w * vec4(vFieldPoint, 1.0);
  vec4 x = dFdx(place);
  vec4 y = dFdy(place);
  return mat2x3(y.w * vFieldPoint - y.xyz, x.xyz - x.w * vFieldPoint) / gl_FragCoord.w;
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
