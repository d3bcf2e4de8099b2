// RIGID: vertices move with their object alone, neither by skins nor by morph targets nor as instances.
#ifndef RIGID
  varying mat3 vViewToAnchor; // from the view to where strokes are anchored, linear part
#endif // RIGID
