// The linear map from view space to the space of anchors, in the fragment shader.
#ifdef RIGID
  // The same for all vertices. Object-space normal maps declare the matrix themselves.
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
