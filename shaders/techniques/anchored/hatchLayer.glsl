#if MEDIUM == MEDIUM_STIPPLE
  #include "technique/stipple"
#else
  #include "technique/strokes"
#endif // MEDIUM
