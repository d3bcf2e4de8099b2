// From vertex to fragment. Face normals are equal at the three corners of a triangle, so they need no `flat`.
#if TECHNIQUE == TECHNIQUE_ADJACENCY
  varying vec4 vStrokeUvCentralAlpha; // (u, v) in the frame of c, then of α
  varying vec4 vStrokeUvBetaGamma; // (u, v) in the frame of β, then of γ
  varying vec3 vBlendFactors; // f of α, β, γ; may be negative: clamped per fragment, after interpolation
  varying mat4x3 vFaceNormals; // of c, α, β, γ, view space
#elif TECHNIQUE == TECHNIQUE_ANCHORED
  varying vec3 vRestPosition; // object space
  varying vec3 vStrokeNormal; // at the scale of a stroke, object space
  varying vec3 vToViewer; // object space, of any length
  varying mat3 vViewToObject; // linear part
#else
  varying vec2 vStrokeUv;
  varying vec3 vFaceNormal; // view space
#endif // TECHNIQUE
#if STROKE_LAYERS == 2 && TECHNIQUE != TECHNIQUE_ANCHORED
  varying vec4 vCrossing; // how far the lights disagree in the frames of c, α, β, γ
#endif // STROKE_LAYERS
#if TECHNIQUE == TECHNIQUE_ANCHORED || LEVEL_RULE == LEVEL_RULE_DEPTH
  #define USE_UNITS_PER_PIXEL
  varying float vUnitsPerPixel; // object units to a pixel
#endif // TECHNIQUE
