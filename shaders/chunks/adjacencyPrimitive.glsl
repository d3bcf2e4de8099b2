// The triangle adjacency primitive (paper, figure 5) of the corner being processed, in object space.

struct AdjacencyPrimitive {
  int corner; // which of v0, v1, v2 this vertex is
  vec3 v0, v1, v2;
  vec3 vAlpha, vBeta, vGamma;
};

#if VERTEX_LAYOUT == VERTEX_LAYOUT_CORNER

// #include "cornerAttributes" declares the attributes from the table in src/bake/cornerLayout.ts.
#include "cornerAttributes"

AdjacencyPrimitive readDrawnPrimitive() {
  int corner = int(cornerNext.w + 0.5);
  // The others are stored relative to the own corner. Undoing that gives all three corners of the triangle the same
  // operands in the same order, hence bit-identical frames and nothing to interpolate but what differs by corner.
  vec3 next = cornerNext.xyz;
  vec3 v0 = corner == 0 ? position : corner == 1 ? cornerPrevious : next;
  vec3 v1 = corner == 1 ? position : corner == 2 ? cornerPrevious : next;
  vec3 v2 = corner == 2 ? position : corner == 0 ? cornerPrevious : next;
  return AdjacencyPrimitive(corner, v0, v1, v2, oppositeAlpha, oppositeBeta, oppositeGamma);
}

#else

#include "pulledVertices"
#include "turns"
#if VERTEX_LAYOUT == VERTEX_LAYOUT_DEFORMING
  uniform highp sampler2D deformedPositions;
  uniform highp sampler2D deformedNormals;
  uniform highp sampler2D deformedTurns;
#endif // VERTEX_LAYOUT

AdjacencyPrimitive pullPrimitive(const in highp sampler2D positions) {
  uvec4 own = ownVertices(gl_VertexID / 3);
  uvec4 opposite = oppositeVertices(gl_VertexID / 3);
  return AdjacencyPrimitive(
    gl_VertexID % 3,
    pullVertex(positions, own.x), pullVertex(positions, own.y), pullVertex(positions, own.z),
    pullVertex(positions, opposite.x), pullVertex(positions, opposite.y), pullVertex(positions, opposite.z)
  );
}

AdjacencyPrimitive readDrawnPrimitive() {
  #if VERTEX_LAYOUT == VERTEX_LAYOUT_DEFORMING
    return pullPrimitive(deformedPositions);
  #else
    return pullPrimitive(restPositions);
  #endif // VERTEX_LAYOUT
}

#endif // VERTEX_LAYOUT

// What the strokes are fixed to.
AdjacencyPrimitive readAnchorPrimitive(const in AdjacencyPrimitive drawn) {
  #ifdef ANCHORED_AT_REST
    return pullPrimitive(restPositions);
  #else
    return drawn;
  #endif // ANCHORED_AT_REST
}

// By which rotations skins turn the triangles c, α, β, γ: quaternions, not of unit length, zero where that is not known.
struct AdjacencyTurns {
  vec4 c, alpha, beta, gamma;
};

AdjacencyTurns readTurns() {
  #ifdef ANCHORED_AT_REST
    uvec4 own = ownVertices(gl_VertexID / 3);
    uvec4 opposite = oppositeVertices(gl_VertexID / 3);
    vec4 v0 = pullTexel(deformedTurns, own.x);
    vec4 v1 = pullTexel(deformedTurns, own.y);
    vec4 v2 = pullTexel(deformedTurns, own.z);
    return AdjacencyTurns(
      addTurns(v0, v1, v2),
      addTurns(v1, v0, pullTexel(deformedTurns, opposite.x)),
      addTurns(v2, v1, pullTexel(deformedTurns, opposite.y)),
      addTurns(v0, v2, pullTexel(deformedTurns, opposite.z))
    );
  #else
    return AdjacencyTurns(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  #endif // ANCHORED_AT_REST
}

// Each neighbour is rebuilt from the shared edge, turned round, and its opposite vertex. That orients it like c even where
// the mesh winds it the other way.
Triangle triangleC(const in AdjacencyPrimitive p) { return Triangle(p.v0, p.v1, p.v2); }
Triangle triangleAlpha(const in AdjacencyPrimitive p) { return Triangle(p.v1, p.v0, p.vAlpha); }
Triangle triangleBeta(const in AdjacencyPrimitive p) { return Triangle(p.v2, p.v1, p.vBeta); }
Triangle triangleGamma(const in AdjacencyPrimitive p) { return Triangle(p.v0, p.v2, p.vGamma); }
