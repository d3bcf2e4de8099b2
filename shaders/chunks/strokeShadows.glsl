// Shadows in places along a stroke of a hand, so that it ends at their edges, and is not cut.
#if defined(USE_SHADOWMAP) && SHADOW_STROKES != SHADOW_STROKES_REORIENT && TONE_MODEL != TONE_MODEL_SHADOW
  #define SHADOWS_ALONG_STROKES
  #ifndef DOUBLE_SIDED
    #include "shadowMatrices"
  #endif // DOUBLE_SIDED
  #include "shadowDepth"
  #include "cascades"

  // The radiance that each light sends to this fragment, and what of it arrives, by the number of the light.
  vec2 sent[LIGHTS_WITH_DIRECTION];
  // Their sums over the lights whose shadow maps are read.
  vec2 castHere = vec2(0.0);

  void sumCastLight(const in vec3 viewPosition) {
    if (!receiveShadow) return;
    IncidentLight light;
    #define VISIT_SHADOW(number, map, matrix, shadow) castHere += sent[number];
    #include "eachFlatPlace"
    #ifdef CUBE_SHADOW_MAP
      #define VISIT_SHADOW(number, map, fromLight, shadow) castHere += sent[number];
      #include "eachCubeShadow"
    #endif // CUBE_SHADOW_MAP
  }

  float passesFlat(FLAT_SHADOW_MAP map, const in ShadowMapFacts facts, const in vec4 at) {
    vec3 place = at.xyz / at.w;
    if (at.w <= 0.0 || any(greaterThan(abs(place - 0.5), vec3(0.5)))) return 1.0;
    return passes(map, facts, at, place.z);
  }

  // The share of the light of these lights that their shadows take at a place near this fragment, without soft edges. viewPosition and
  // normal: view space.
  float shadowAt(const in vec3 viewPosition, const in vec3 normal) {
    vec3 point = (vec4(viewPosition - viewMatrix[3].xyz, 0.0) * viewMatrix).xyz;
    vec3 up = (vec4(normal, 0.0) * viewMatrix).xyz;
    float taken = 0.0;
    IncidentLight light;
    #define TAKEN(number, shadow, passing) taken += sent[number].x * shadow.shadowIntensity * (1.0 - passing);
    #define VISIT_SHADOW(number, map, matrix, shadow) TAKEN(number, shadow, passesFlat(map, ShadowMapFacts(shadow.shadowBias, shadow.shadowRadius, shadow.shadowMapSize.x, vec2(0.0)), matrix * vec4(point + shadow.shadowNormalBias * up, 1.0)))
    #include "eachFlatPlace"
    #ifdef CUBE_SHADOW_MAP
      vec3 fromLamp;
      #define VISIT_SHADOW(number, map, fromLight, shadow) fromLamp = (vec4(fromLight, 0.0) * viewMatrix).xyz + shadow.shadowNormalBias * up; TAKEN(number, shadow, passes(map, ShadowMapFacts(shadow.shadowBias, shadow.shadowRadius, shadow.shadowMapSize.x, vec2(shadow.shadowCameraNear, shadow.shadowCameraFar)), vec4(fromLamp, 0.0), length(fromLamp)))
      #include "eachCubeShadow"
    #endif // CUBE_SHADOW_MAP
    return castHere.x > 0.0 ? taken / castHere.x : 0.0;
  }
#endif // USE_SHADOWMAP
