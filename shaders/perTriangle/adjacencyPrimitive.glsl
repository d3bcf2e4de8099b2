// The triangle adjacency primitive (paper, figure 5) of the corner being processed, in object space.
struct AdjacencyPrimitive {
  int corner; // which of v0, v1, v2 is this vertex
  vec3 v0, v1, v2;
  vec3 vAlpha, vBeta, vGamma;
};

// Each neighbour is rebuilt from the reversed shared edge and its opposite vertex. That orients it like c even where the mesh winds it the
// other way.
Triangle triangleC(const in AdjacencyPrimitive p) { return Triangle(p.v0, p.v1, p.v2); }
Triangle triangleAlpha(const in AdjacencyPrimitive p) { return Triangle(p.v1, p.v0, p.vAlpha); }
Triangle triangleBeta(const in AdjacencyPrimitive p) { return Triangle(p.v2, p.v1, p.vBeta); }
Triangle triangleGamma(const in AdjacencyPrimitive p) { return Triangle(p.v0, p.v2, p.vGamma); }

// Rotations of the triangles c, α, β, γ by skinning: quaternions, not of unit length; zero where not known.
struct AdjacencyTurns {
  vec4 c, alpha, beta, gamma;
};
