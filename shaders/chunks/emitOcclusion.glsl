// Instances are at many places, and have none. They need their attributes for themselves, too.
#if defined(USE_INSTANCING) || defined(USE_BATCHING)
  vOcclusion = 0.0;
#else
  vOcclusion = max(-hatchNormal.w, 0.0);
#endif // USE_INSTANCING
