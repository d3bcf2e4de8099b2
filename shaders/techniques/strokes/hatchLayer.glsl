#if TECHNIQUE == TECHNIQUE_STIPPLE
  #include "technique/stipple"
#else
  #include "technique/strokes"
#endif // TECHNIQUE
