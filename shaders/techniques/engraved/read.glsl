// What engraving needs to know at this fragment: the functions that lines are level sets of, and how they lie on the screen.
#include "perFragment/viewToAnchor"

uniform mat3 objectToField; // linear part

#include "technique/hand"
#include "perFragment/screenGradient"

// Lines that are level sets of one function.
struct Family {
  float value;
  float perPixel; // its change from one pixel to the next, by the smooth normal
  float seen; // the same on the flat triangle, as it is seen
  float rise; // its change along the surface, per tile, by which lines are spaced on the object
  vec3 gradient; // of any length; lines lie across it
  float coarsest; // the octave of the lines that lie farthest apart
};

#ifdef FOLLOWS_FORM
  #include "technique/readForm"
#else
  #include "technique/readCut"
#endif // FOLLOWS_FORM
