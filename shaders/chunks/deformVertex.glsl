// Object-space position and normal as drawn. Six vertices would have to be deformed for each corner; a pre-pass does each
// of them once. Where the others are not asked for, three deforms the vertex here.
#if TECHNIQUE != TECHNIQUE_ANCHORED && VERTEX_LAYOUT == VERTEX_LAYOUT_DEFORMING
  uint ownVertex = ownVertices(gl_VertexID / 3)[gl_VertexID % 3];
  transformed = pullVertex(deformedPositions, ownVertex);
  objectNormal = pullVertex(deformedNormals, ownVertex);
#else
  #include <morphnormal_vertex>
  vec3 morphedNormal = objectNormal;
  #include <skinbase_vertex>
  #include <skinnormal_vertex>
  #include <morphtarget_vertex>
  #include <skinning_vertex>
#endif // TECHNIQUE
