{
  mat4 objectToView = modelViewMatrix;
  #ifdef USE_BATCHING
    objectToView = objectToView * batchingMatrix;
  #endif // USE_BATCHING
  #ifdef USE_INSTANCING
    objectToView = objectToView * instanceMatrix;
  #endif // USE_INSTANCING
  mat3 viewToObject = inverse(mat3(objectToView));
  mat3 viewToAnchor = viewToObject;

#if TECHNIQUE == TECHNIQUE_ANCHORED
  mat3 deformedToRest = mat3(1.0);
  #ifdef USE_SKINNING
    mat3 skin = mat3(skinMatrix);
    if (determinant(skin) != 0.0) deformedToRest = inverse(skin);
  #endif // USE_SKINNING
  #ifdef USE_MORPHNORMALS
    // Morph targets move vertices, they turn nothing. What they do to the normal is all that is known here.
    deformedToRest = rotationBetween(morphedNormal, normal) * deformedToRest;
  #endif // USE_MORPHNORMALS

  // Geometry that was never prepared still has its own normals.
  vStrokeNormal = dot(hatchNormal, hatchNormal) > 0.25 ? hatchNormal : normal;
  #if STROKE_ANCHOR == STROKE_ANCHOR_REST
    vRestPosition = position;
    viewToAnchor = deformedToRest * viewToObject;
  #else
    vRestPosition = transformed;
    // From the left is the transpose: what the inverse transpose of the deformation is to the normal.
    vStrokeNormal = vStrokeNormal * deformedToRest;
  #endif // STROKE_ANCHOR
  vViewToObject = viewToAnchor;
  vToViewer = viewToAnchor * (isOrthographic ? vec3(0.0, 0.0, 1.0) : vViewPosition);
#else
  AdjacencyPrimitive drawn = readDrawnPrimitive();
  AdjacencyPrimitive anchor = readAnchorPrimitive(drawn);
  AdjacencyTurns turns = readTurns();
  #if VERTEX_LAYOUT == VERTEX_LAYOUT_DEFORMING && !defined(ANCHORED_AT_REST)
    vec3 anchorPosition = transformed;
  #else
    vec3 anchorPosition = position;
  #endif // VERTEX_LAYOUT
  vec3 normalC = normalOf(triangleC(drawn));
  vec3 strokesC = strokeCoordinates(
    anchorPosition, triangleC(anchor), triangleC(drawn), normalC, turns.c, objectToView, viewToObject
  );

  // A normal times the inverse from the left is the inverse transpose times the normal: right for every matrix.
  #if TECHNIQUE == TECHNIQUE_ADJACENCY
    vec3 normalAlpha = normalOf(triangleAlpha(drawn));
    vec3 normalBeta = normalOf(triangleBeta(drawn));
    vec3 normalGamma = normalOf(triangleGamma(drawn));
    vec3 strokesAlpha = strokeCoordinates(
      anchorPosition, triangleAlpha(anchor), triangleAlpha(drawn), normalAlpha, turns.alpha, objectToView, viewToObject
    );
    vec3 strokesBeta = strokeCoordinates(
      anchorPosition, triangleBeta(anchor), triangleBeta(drawn), normalBeta, turns.beta, objectToView, viewToObject
    );
    vec3 strokesGamma = strokeCoordinates(
      anchorPosition, triangleGamma(anchor), triangleGamma(drawn), normalGamma, turns.gamma, objectToView, viewToObject
    );
    vStrokeUvCentralAlpha = vec4(strokesC.xy, strokesAlpha.xy);
    vStrokeUvBetaGamma = vec4(strokesBeta.xy, strokesGamma.xy);
    #if STROKE_LAYERS == 2
      vCrossing = vec4(strokesC.z, strokesAlpha.z, strokesBeta.z, strokesGamma.z);
    #endif // STROKE_LAYERS
    // −1 at the vertex that does not belong to the neighbour (Algorithm 2): corner 2 for α, 0 for β, 1 for γ.
    vBlendFactors = vec3(
      drawn.corner == 2 ? -1.0 : sharedBlendFactor(normalC, normalAlpha),
      drawn.corner == 0 ? -1.0 : sharedBlendFactor(normalC, normalBeta),
      drawn.corner == 1 ? -1.0 : sharedBlendFactor(normalC, normalGamma)
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
  float scale = pow(abs(determinant(viewToAnchor)), 1.0 / 3.0);
  vUnitsPerPixel = distance * scale * 2.0 / (projectionMatrix[1][1] * viewportHeight);
#endif // USE_UNITS_PER_PIXEL
}
