{
  mat4 objectToView = modelViewMatrix;
  #ifdef USE_BATCHING
    objectToView = objectToView * batchingMatrix;
  #endif // USE_BATCHING
  #ifdef USE_INSTANCING
    objectToView = objectToView * instanceMatrix;
  #endif // USE_INSTANCING
  mat3 viewToObject = inverse(mat3(objectToView));

#if TECHNIQUE == TECHNIQUE_ANCHORED
  vRestPosition = position;
  // Geometry that was never prepared still has its own normals.
  vStrokeNormal = dot(hatchNormal, hatchNormal) > 0.25 ? hatchNormal : normal;
  vViewToObject = viewToObject;
#else
  AdjacencyPrimitive p = readAdjacencyPrimitive();
  vec3 normalC = triangleNormal(p.v0, p.v1, p.v2);
  vec3 strokesC = strokeCoordinates(position, normalC, (p.v0 + p.v1 + p.v2) / 3.0, objectToView, viewToObject);

  // A normal times the inverse from the left is the inverse transpose times the normal: right for every matrix.
  #if TECHNIQUE == TECHNIQUE_ADJACENCY
    // Each neighbour is rebuilt from the shared edge, turned round, and its opposite vertex. That orients it like c
    // even where the mesh winds it the other way.
    vec3 normalAlpha = triangleNormal(p.v1, p.v0, p.vAlpha);
    vec3 normalBeta = triangleNormal(p.v2, p.v1, p.vBeta);
    vec3 normalGamma = triangleNormal(p.v0, p.v2, p.vGamma);
    vec3 strokesAlpha = strokeCoordinates(position, normalAlpha, (p.v1 + p.v0 + p.vAlpha) / 3.0, objectToView, viewToObject);
    vec3 strokesBeta = strokeCoordinates(position, normalBeta, (p.v2 + p.v1 + p.vBeta) / 3.0, objectToView, viewToObject);
    vec3 strokesGamma = strokeCoordinates(position, normalGamma, (p.v0 + p.v2 + p.vGamma) / 3.0, objectToView, viewToObject);
    vStrokeUvCentralAlpha = vec4(strokesC.xy, strokesAlpha.xy);
    vStrokeUvBetaGamma = vec4(strokesBeta.xy, strokesGamma.xy);
    #if STROKE_LAYERS == 2
      vCrossing = vec4(strokesC.z, strokesAlpha.z, strokesBeta.z, strokesGamma.z);
    #endif // STROKE_LAYERS
    // −1 at the vertex that does not belong to the neighbour (Algorithm 2): corner 2 for α, 0 for β, 1 for γ.
    vBlendFactors = vec3(
      p.corner == 2 ? -1.0 : sharedBlendFactor(normalC, normalAlpha),
      p.corner == 0 ? -1.0 : sharedBlendFactor(normalC, normalBeta),
      p.corner == 1 ? -1.0 : sharedBlendFactor(normalC, normalGamma)
    );
    vFaceNormals = mat4x3(
      normalC * viewToObject, normalAlpha * viewToObject, normalBeta * viewToObject, normalGamma * viewToObject
    );
  #else
    vStrokeUv = strokesC.xy;
    #if STROKE_LAYERS == 2
      vCrossing = vec4(strokesC.z);
    #endif // STROKE_LAYERS
    vFaceNormal = normalC * viewToObject;
  #endif // TECHNIQUE
#endif // TECHNIQUE

#ifdef USE_UNITS_PER_PIXEL
  float distance = isOrthographic ? 1.0 : -mvPosition.z;
  // The cube root of the volume a view-space unit cube takes in object space: the mean of the scale over directions.
  float scale = pow(abs(determinant(viewToObject)), 1.0 / 3.0);
  vUnitsPerPixel = distance * scale * 2.0 / (projectionMatrix[1][1] * viewportHeight);
#endif // USE_UNITS_PER_PIXEL
}
