// Object-space position and normal as drawn. Six vertices would have to be deformed for each corner; a pre-pass does each
// of them once. Where the others are not asked for, three deforms the vertex here.
#if VERTEX_LAYOUT == VERTEX_LAYOUT_DEFORMING
  uint ownVertex = ownVertices(gl_VertexID / 3)[gl_VertexID % 3];
  transformed = pullVertex(deformedPositions, ownVertex);
  objectNormal = pullVertex(deformedNormals, ownVertex);
#else
  #include "deformVertex"
#endif // VERTEX_LAYOUT
