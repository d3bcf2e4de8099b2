// The parameters of engraving at this fragment: the functions whose level sets are lines, and their derivatives on the screen.
#include "perFragment/viewToAnchor"

uniform mat3 objectToField; // linear part

#include "technique/hand"
#include "perFragment/screenGradient"

// Lines that are level sets of one function.
struct Family {
  float value;
  float perPixel; // change from one pixel to the next, on the smooth surface
  float trianglePerPixel; // the same on the flat triangle
  float rise; // change along the surface, per tile, by which lines are spaced on the object
  vec3 gradient; // of any length; lines lie across it
  float coarsest; // octave of the widest spacing of its lines
};

#ifdef FOLLOWS_FORM
  #include "technique/readForm"
#else
  #include "technique/readCut"
#endif // FOLLOWS_FORM
