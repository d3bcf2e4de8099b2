// Strokes that follow the light.
uniform vec2 strokeDirection; // cosine and sine of the angle by which strokes are turned, counterclockwise

// n: unit normal, object space.
void readStrokeAxes(const in vec3 n, inout HatchingParameters h) {
  vec3 bitangent = lightBitangent(n, -vViewPosition, readViewToAnchor(), h.crossing);
  vec3 tangent = cross(bitangent, n);
  h.uAxis = strokeDirection.x * tangent + strokeDirection.y * bitangent;
  h.vAxis = strokeDirection.x * bitangent - strokeDirection.y * tangent;
}
