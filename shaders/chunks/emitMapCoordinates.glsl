#if defined(USE_UV) || defined(USE_UV0)
  vUv = uv;
#endif // USE_UV
#ifdef USE_UV1
  vUv1 = uv1;
#endif // USE_UV1
#ifdef USE_UV2
  vUv2 = uv2;
#endif // USE_UV2
#ifdef USE_UV3
  vUv3 = uv3;
#endif // USE_UV3
