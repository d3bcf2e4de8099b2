// The field at this fragment.
#ifndef FIELD_BY_VERTEX
  #if defined(REORIENTS_IN_SHADOW) && defined(TURNS_WITH_LIGHT)
    #include "technique/lightField"

    // The light of the field, from the lights that arrive; where none does, a direction across it. It is constant where the same lights
    // arrive.
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
  #elif defined(TURNS_WITH_LIGHT) || defined(RUNS_AWAY)
    vec4 arrivingLight() {
      return vFieldLight;
    }
  #else
    // Fields along an axis of the object need no light.
    vec4 arrivingLight() {
      return vec4(0.0);
    }
  #endif // REORIENTS_IN_SHADOW
#endif // FIELD_BY_VERTEX

// side: a unit vector across the axis.
Field fieldAtFragment(out vec3 side) {
  #ifdef FIELD_BY_VERTEX
    side = vFieldSide;
    return Field(vField.xyz, vField.w);
  #else
    Field field = firstField(arrivingLight());
    side = across(field.axis);
    return field;
  #endif // FIELD_BY_VERTEX
}
