{
  // Instances stand in different places, so occlusion is not baked for them. Not reading the attribute leaves room for those of instancing.
  #if defined(USE_INSTANCING) || defined(USE_BATCHING)
    vec2 ofSides = vec2(0.0);
  #else
    vec2 ofSides = occlusionOfSides(hatchNormal.w);
  #endif // USE_INSTANCING
  #ifdef DOUBLE_SIDED
    vOcclusion = ofSides;
  #elif defined(FLIP_SIDED)
    vOcclusion = ofSides.y;
  #else
    vOcclusion = ofSides.x;
  #endif // DOUBLE_SIDED
}
