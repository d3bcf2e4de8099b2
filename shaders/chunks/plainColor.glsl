// Where one colour holds for the whole surface, vertices compute its darkness.
#if !defined(USE_MAP) && !defined(USE_EMISSIVEMAP) && !defined(USE_COLOR) && !defined(USE_COLOR_ALPHA)
  #if !defined(USE_INSTANCING_COLOR) && !defined(USE_BATCHING_COLOR)
    #define PLAIN_COLOR
    varying float vDarkness;
  #endif // USE_INSTANCING_COLOR
#endif // USE_MAP
