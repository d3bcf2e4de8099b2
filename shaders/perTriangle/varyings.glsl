#if LEVEL_RULE == LEVEL_RULE_DEPTH
  varying float vUnitsPerPixel; // object units per pixel
#endif // LEVEL_RULE
