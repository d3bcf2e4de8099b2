// The source of a vertex's adjacency primitive, as drawn and as strokes are fixed to it.
#if VERTEX_LAYOUT == VERTEX_LAYOUT_CORNER
  #include "perTriangle/cornerVertices"
  #include "perTriangle/anchorAsDrawn"
#elif VERTEX_LAYOUT == VERTEX_LAYOUT_PULL
  #include "perTriangle/restVertices"
  #include "perTriangle/anchorAsDrawn"
#else
  #include "perTriangle/deformedVertices"
  #if STROKE_ANCHOR == STROKE_ANCHOR_REST
    #include "perTriangle/anchorAtRest"
  #else
    #include "perTriangle/anchorAsDrawn"
  #endif // STROKE_ANCHOR
#endif // VERTEX_LAYOUT
