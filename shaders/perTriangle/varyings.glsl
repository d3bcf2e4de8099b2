#if LEVEL_RULE == LEVEL_RULE_DEPTH
  varying float vUnitsPerPixel; // object units to a pixel
#endif // LEVEL_RULE
