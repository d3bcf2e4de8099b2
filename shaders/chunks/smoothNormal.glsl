// three.js interpolates a normal unless shading is flat. Only tone by the smooth normal reads it; for others this saves a varying.
#if TONE_NORMAL == TONE_NORMAL_FACE && !defined(FLAT_SHADED)
  #define FLAT_SHADED
  #undef USE_TANGENT
#endif // TONE_NORMAL
