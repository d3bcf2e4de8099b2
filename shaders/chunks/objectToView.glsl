mat4 objectToView = modelViewMatrix;
#ifdef USE_BATCHING
  objectToView = objectToView * batchingMatrix;
#endif // USE_BATCHING
#ifdef USE_INSTANCING
  objectToView = objectToView * instanceMatrix;
#endif // USE_INSTANCING
mat3 viewToObject = inverse(mat3(objectToView)); // linear part
