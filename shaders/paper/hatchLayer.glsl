// Algorithm 3: the darkness of one layer of strokes, blended as greys or, beyond the paper, before ink is decided.
#include "paper/levelRules"
#ifdef CRISP
  #include "thresholdMap"
  #include "paper/crispLevel"
  #include "technique/crisp"
#else
  #include "paper/tonalArtMap"
  #include "technique/greys"
#endif // CRISP
