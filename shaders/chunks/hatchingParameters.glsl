// Algorithms 1 and 2: for one vertex, the hatching parameters H = (s, t, f) of the triangles c, α, β, γ.

uniform mat3 strokeTransform; // H(s, t) → texture coordinates: rotation, then scale, then offset
uniform float creaseCosine; // cos of the angle between normals from which neighbours no longer blend

#ifdef ANCHORED_AT_REST
// The linear map by which the light is carried from a triangle as drawn to the same at rest. The turn of the skin, where that
// alone moves the triangle, is exact; corners are rounded, and the smaller the triangle the more that turns it.
mat3 drawnToAnchor(const in Triangle drawn, const in Triangle anchor, const in vec4 turn) {
  return turn == vec4(0.0) ? triangleToTriangle(drawn, anchor) : turnBack(turn);
}
#endif // ANCHORED_AT_REST

// Texture coordinates of `vertex`, and `crossing` of the lights, in the frame (T, B, N) of the triangle `anchor`, drawn as
// `drawn` with the normal `drawnNormal`. It is the same triangle unless strokes of a mesh that deforms are anchored in its
// rest pose; then the light falls on the one and is carried to the other.
//
// Algorithm 2 projects the vertex into the plane of the triangle first. T and B lie in that plane, so V'·T = V·T and
// V'·B = V·B, and there is nothing to project.
vec3 strokeCoordinates(
  const in vec3 vertex, const in Triangle anchor, const in Triangle drawn, const in vec3 drawnNormal,
  const in vec4 turn, const in mat4 objectToView, const in mat3 viewToObject
) {
  #ifdef ANCHORED_AT_REST
    vec3 n = normalOf(anchor);
    mat3 viewToAnchor = drawnToAnchor(drawn, anchor, turn) * viewToObject;
  #else
    vec3 n = drawnNormal;
    mat3 viewToAnchor = viewToObject;
  #endif // ANCHORED_AT_REST
  vec3 centre = (drawn.a + drawn.b + drawn.c) / 3.0;
  float crossing;
  vec3 bitangent = lightBitangent(n, (objectToView * vec4(centre, 1.0)).xyz, viewToAnchor, crossing);
  vec3 tangent = cross(bitangent, n);
  return vec3((strokeTransform * vec3(dot(vertex, tangent), dot(vertex, bitangent), 1.0)).xy, crossing);
}

// Algorithm 2's f at the vertices shared with a neighbour: N_c·N_t, with the crease angle moved to zero.
float sharedBlendFactor(const in vec3 centralNormal, const in vec3 neighbourNormal) {
  float cosine = dot(centralNormal, neighbourNormal);
  return max((cosine - creaseCosine) / (1.0 - creaseCosine), -1.0);
}
