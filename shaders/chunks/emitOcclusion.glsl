// Instances stand in different places, so occlusion is not baked for them. Not reading the attribute leaves room for those of instancing.
#if defined(USE_INSTANCING) || defined(USE_BATCHING)
  vOcclusion = 0.0;
#else
  vOcclusion = max(-hatchNormal.w, 0.0);
#endif // USE_INSTANCING
