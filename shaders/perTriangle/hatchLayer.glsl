// Algorithm 3: the darkness of one layer of strokes, blended as greys or, beyond the paper, as fields.
#include "perTriangle/levelRules"
#ifdef SHARP_INK
  #include "thresholdMap"
  #include "ink"
  #include "perTriangle/crispLevel"
  #include "technique/crisp"
#else
  #include "perTriangle/tonalArtMap"
  #include "technique/greys"
#endif // SHARP_INK
