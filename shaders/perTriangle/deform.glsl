// Deformed position and normal, object space. A corner needs six deformed vertices, so the deformation pass deforms each vertex once. Where
// the others are not needed, three.js' chunks deform this vertex here.
#if VERTEX_LAYOUT == VERTEX_LAYOUT_DEFORMING
  uint ownVertex = ownVertices(gl_VertexID / 3)[gl_VertexID % 3];
  transformed = pullVertex(deformedPositions, ownVertex);
  objectNormal = pullVertex(deformedNormals, ownVertex);
#else
  #include "deformVertex"
#endif // VERTEX_LAYOUT
