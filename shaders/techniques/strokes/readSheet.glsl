// Strokes with a fixed direction on the sheet, as one hand draws them.
uniform vec2 strokeDirection; // cosine and sine of the angle from the horizontal, counterclockwise

// n: unit normal, object space.
void readStrokeAxes(const in vec3 n, inout HatchingParameters h) {
  mat3 viewToAnchor = readViewToAnchor();
  vec3 toViewer = isOrthographic ? vec3(0.0, 0.0, 1.0) : vViewPosition;
  // The intersection of the surface with the plane through the eye and a slanted line of the sheet.
  vec3 along = cross(n * viewToAnchor, cross(vec3(strokeDirection, 0.0), toViewer));
  along = viewToAnchor * along;
  float squaredLength = dot(along, along);
  h.uAxis = squaredLength > 0.0 ? along * inversesqrt(squaredLength) : normalize(anyTangent(n));
  h.vAxis = cross(n, h.uAxis);
  h.crossing = 0.0;
}
