// Strokes fixed to the deformed triangles.

AdjacencyPrimitive readAnchorPrimitive(const in AdjacencyPrimitive drawn) {
  return drawn;
}

vec3 readAnchorPosition(const in vec3 drawn) {
  return drawn;
}

AdjacencyTurns readTurns() {
  return AdjacencyTurns(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
}

vec3 anchorNormal(const in Triangle anchor, const in vec3 drawnNormal) {
  return drawnNormal;
}

mat3 viewToAnchor(const in mat3 viewToObject, const in Triangle drawn, const in Triangle anchor, const in vec4 turn) {
  return viewToObject;
}
