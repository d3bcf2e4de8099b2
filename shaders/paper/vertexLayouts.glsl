// Where a vertex finds its adjacency primitive as drawn, and the one its strokes are fixed to.
#if VERTEX_LAYOUT == VERTEX_LAYOUT_CORNER
  #include "paper/cornerVertices"
  #include "paper/anchorAsDrawn"
#elif VERTEX_LAYOUT == VERTEX_LAYOUT_PULL
  #include "paper/restVertices"
  #include "paper/anchorAsDrawn"
#else
  #include "paper/deformedVertices"
  #if STROKE_ANCHOR == STROKE_ANCHOR_REST
    #include "paper/anchorAtRest"
  #else
    #include "paper/anchorAsDrawn"
  #endif // STROKE_ANCHOR
#endif // VERTEX_LAYOUT
