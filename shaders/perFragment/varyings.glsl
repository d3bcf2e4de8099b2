// RIGID: vertices move with their object alone, without skinning, morph targets or instances.
#ifndef RIGID
  varying mat3 vViewToAnchor; // from view space to the space of anchors, linear part
#endif // RIGID
