#ifdef REORIENTS_IN_SHADOW
  // Whether no directed light arrives.
  bool isInFullShadow() {
    bool isAll = true;
    for (int i = 0; i < LIGHTS_WITH_DIRECTION; i++) isAll = isAll && isLightShadowed[i];
    return isAll;
  }
#endif // REORIENTS_IN_SHADOW
