// three interpolates a normal unless shading is flat. Only smooth tone looks at it; for the others it would be a row of varyings.
#if TONE_NORMAL == TONE_NORMAL_FACE && !defined(FLAT_SHADED)
  #define FLAT_SHADED
  #undef USE_TANGENT
#endif // TONE_NORMAL
