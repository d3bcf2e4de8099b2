// The linear map from the view to where strokes are anchored, for the fragment shader.
#ifdef RIGID
  // One for all vertices. Maps of normals in object space declare the matrix themselves.
  #ifndef USE_NORMALMAP_OBJECTSPACE
    uniform mat3 normalMatrix;
  #endif // USE_NORMALMAP_OBJECTSPACE

  mat3 readViewToAnchor() {
    return transpose(normalMatrix);
  }
#else
  mat3 readViewToAnchor() {
    return vViewToAnchor;
  }
#endif // RIGID
