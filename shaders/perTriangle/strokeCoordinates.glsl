// Algorithms 1 and 2: the (s, t) of one vertex in the frame of one of the triangles c, α, β, γ.

uniform mat3 strokeTransform; // (s, t) → texture coordinates: rotation, then scale, then offset

// Texture coordinates of `vertex`, and `crossing` of the lights, in the frame (T, B, N) of the triangle `anchor`, which is drawn as `drawn`
// with the normal `drawnNormal`. They differ only where strokes of a mesh that deforms are anchored in its rest pose: the light falls on
// `drawn` and is mapped to `anchor`.
//
// Algorithm 2 projects the vertex into the plane of the triangle first. T and B lie in that plane, so V'·T = V·T and V'·B = V·B, and the
// projection is left out.
vec3 strokeCoordinates(
  const in vec3 vertex, const in Triangle anchor, const in Triangle drawn, const in vec3 drawnNormal,
  const in vec4 turn, const in mat4 objectToView, const in mat3 viewToObject
) {
  vec3 n = anchorNormal(anchor, drawnNormal);
  vec3 centre = (drawn.a + drawn.b + drawn.c) / 3.0;
  float crossing;
  vec3 bitangent = lightBitangent(
    n, (objectToView * vec4(centre, 1.0)).xyz, viewToAnchor(viewToObject, drawn, anchor, turn), crossing
  );
  // V·T of T = B × N.
  vec2 st = vec2(dot(bitangent, cross(n, vertex)), dot(bitangent, vertex));
  return vec3((strokeTransform * vec3(st, 1.0)).xy, crossing);
}
