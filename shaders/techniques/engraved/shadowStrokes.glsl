#if SHADOW_STROKES == SHADOW_STROKES_CROSS
  // Families that lean the other way, across the first and across those of its darks.
  float shadowLayer(const in HatchingParameters h, const in float tone) {
    float darkness = families(h, 0.0, tone, vec2(cos(crossAngle), -sin(crossAngle)));
    return tone >= 1.0 ? 1.0 : darkness;
  }
#else
  #include "technique/lightField"

  // The field of the lights that arrive; where none does, across the light. It is one for all places where the same do.
  HatchingParameters reorientedInShadow(const in HatchingParameters h) {
    bool isAny = false;
    bool isAll = true;
    for (int i = 0; i < LIGHTS_WITH_DIRECTION; i++) {
      isAny = isAny || isLightShadowed[i];
      isAll = isAll && isLightShadowed[i];
    }
    if (!isAny) return h;
    if (isAll) return engravedParameters(firstField(vec4(across(vFieldLight.xyz), 0.0)));
    return engravedParameters(firstField(fieldLight(vViewToField, -vViewPosition, vFieldPoint)));
  }
#endif // SHADOW_STROKES
