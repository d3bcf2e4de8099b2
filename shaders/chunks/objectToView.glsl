mat4 objectToView = modelViewMatrix;
#if defined(USE_INSTANCING) || defined(USE_BATCHING)
  #ifdef USE_BATCHING
    objectToView = objectToView * batchingMatrix;
  #endif // USE_BATCHING
  #ifdef USE_INSTANCING
    objectToView = objectToView * instanceMatrix;
  #endif // USE_INSTANCING
  mat3 viewToObject = inverse(mat3(objectToView)); // linear part
#else
  // three.js' normalMatrix is the inverse transpose, the same for all vertices.
  mat3 viewToObject = transpose(normalMatrix);
#endif // USE_INSTANCING
