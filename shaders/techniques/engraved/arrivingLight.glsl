// The light of the field at this fragment.
#ifdef REORIENTS_IN_SHADOW
  #include "technique/lightField"

  // The light of the field, as if there were only the lights that arrive; where none does, a direction across it. It is the same for
  // all places that the same lights reach.
  vec4 arrivingLight() {
    bool isAny = false;
    bool isAll = true;
    for (int i = 0; i < LIGHTS_WITH_DIRECTION; i++) {
      isAny = isAny || isLightShadowed[i];
      isAll = isAll && isLightShadowed[i];
    }
    if (!isAny) return vFieldLight;
    if (isAll) return vec4(across(vFieldLight.xyz), 0.0);
    return fieldLight(objectToField * readViewToAnchor(), -vViewPosition, vFieldPoint);
  }
#else
  vec4 arrivingLight() {
    return vFieldLight;
  }
#endif // REORIENTS_IN_SHADOW
