// Shadows whose edges widen and whose tone dissolves with the distance from the occluder.
#if defined(SEPARATES_SHADOWS) && TONE_MODEL == TONE_MODEL_SHADOW
  #define DISSOLVES_SHADOWS

  uniform float shadowTone; // tone of a full shadow where it touches its occluder
  uniform float shadowFade; // share of the tone that is lost over the width of the shadow map
  uniform float shadowSoftness; // width of the edge, as a share of the distance from the occluder

  #ifndef DOUBLE_SIDED
    #include "shadowMatrices"
  #endif // DOUBLE_SIDED
  #include "shadowDepth"

  // Steps of the bisection, enough to show no bands.
  #define HALVINGS 6
  #define LAST_STEP (1.0 / 64.0)
  // Rays begin at this share of their length, so that a surface at a grazing angle does not hit itself.
  #define WITHIN 0.25

  // By the number of the light: the light that passes, below 0 where three.js' function is to be used; and the share of the tone that is
  // left.
  float passing[LIGHTS_WITH_DIRECTION];
  float toneLeft[LIGHTS_WITH_DIRECTION];
  // Luminance that shadows take, and the part of it that has dissolved.
  float shadowTaken = 0.0;
  float shadowLost = 0.0;

  // The share of the tone of all shadows that is left.
  float shadowLeft() {
    return shadowTaken > 0.0 ? 1.0 - shadowLost / shadowTaken : 1.0;
  }

  // Rays from a point to samples on a lamp.
  struct Rays {
    float farthest; // greatest distance of an occluder, world units
    float width; // width of the map at the point
    float nearing; // reciprocal of the distance of a lamp, 0 for a directional light
    vec4 at; // the point on the map: homogeneous on a flat one, the vector from the light on a cube
    vec4 towards; // what a unit of distance along the central ray adds to it
    mat2x4 across; // what units to both sides add
    vec4 depth; // numerator and denominator of the depth at the point, and what a unit of distance adds to them
  };

  float depthAlong(const in Rays rays, const in float distance) {
    vec2 parts = rays.depth.xy + distance * rays.depth.zw;
    return parts.x / parts.y;
  }

  #define SHADOW_MAP FLAT_SHADOW_MAP
  #include "shadowSearch"
  #ifdef CUBE_SHADOW_MAP
    #define SHADOW_MAP CUBE_SHADOW_MAP
    #include "shadowSearch"
  #endif // CUBE_SHADOW_MAP

  // Unit vectors across the light, to both sides.
  mat2x3 besides(const in vec3 toLight) {
    vec3 side = normalize(cross(toLight, abs(toLight.y) < OVERHEAD ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    return mat2x3(side, cross(toLight, side));
  }

  float farthestCaster(const in float width) {
    return width / max(shadowFade, 1.0 / FARTHEST_CASTER);
  }

  // matrix: from world to map. point: world space. toLight: unit, world space. Returns the light that passes and the share of the tone that
  // is left.
  vec2 flatShadow(
    FLAT_SHADOW_MAP map, const in mat4 matrix, const in vec3 point, const in vec3 toLight, const in ShadowMapFacts facts
  ) {
    vec4 at = matrix * vec4(point, 1.0);
    if (at.w <= 0.0 || any(greaterThan(abs(at.xyz / at.w - 0.5), vec3(0.5)))) return vec2(1.0);
    // The width of the map across the light at this distance is at.w divided by the length of this vector.
    vec4 row = vec4(matrix[0][0], matrix[1][0], matrix[2][0], 0.0);
    vec4 lastRow = vec4(matrix[0][3], matrix[1][3], matrix[2][3], 0.0);
    float width = at.w / length(row - 0.5 * lastRow);
    vec4 towards = matrix * vec4(toLight, 0.0);
    mat2x3 sides = besides(toLight);
    mat2x4 across = mat2x4(matrix * vec4(sides[0], 0.0), matrix * vec4(sides[1], 0.0));
    Rays rays = Rays(
      farthestCaster(width), width, max(-towards.w / at.w, 0.0), at, towards, across, vec4(at.zw, towards.zw)
    );
    return shadowSearch(map, facts, rays);
  }

  #ifdef CUBE_SHADOW_MAP
    // fromLight: vector to the point, world space.
    vec2 cubeShadow(CUBE_SHADOW_MAP map, const in vec3 fromLight, const in ShadowMapFacts facts) {
      vec3 onAxes = abs(fromLight);
      float lightDistance = length(fromLight);
      vec3 toLight = -fromLight / lightDistance;
      float width = 2.0 * max(max(onAxes.x, onAxes.y), onAxes.z);
      mat2x3 sides = besides(toLight);
      Rays rays = Rays(
        farthestCaster(width), width, 1.0 / lightDistance, vec4(fromLight, 0.0), vec4(toLight, 0.0),
        mat2x4(vec4(sides[0], 0.0), vec4(sides[1], 0.0)), vec4(lightDistance, 1.0, -1.0, 0.0)
      );
      return shadowSearch(map, facts, rays);
    }
  #endif // CUBE_SHADOW_MAP

  // viewPosition: of the point, view space. To be called before three.js' chunk loops over the lights.
  void readSoftShadows(const in vec3 viewPosition) {
    for (int i = 0; i < LIGHTS_WITH_DIRECTION; i++) {
      passing[i] = -1.0;
      toneLeft[i] = 1.0;
    }
    if (shadowFade == 0.0 && shadowSoftness == 0.0) return;
    vec3 point = (vec4(viewPosition - viewMatrix[3].xyz, 0.0) * viewMatrix).xyz;
    IncidentLight light;
    vec2 found;
    #define READ(number, by, shadow) found = by; toneLeft[number] = found.y; if (shadowSoftness > 0.0) passing[number] = mix(1.0, found.x, shadow.shadowIntensity);
    #define VISIT_SHADOW(number, map, matrix, shadow) READ(number, flatShadow(map, matrix, point, (vec4(light.direction, 0.0) * viewMatrix).xyz, ShadowMapFacts(shadow.shadowBias, shadow.shadowRadius, shadow.shadowMapSize.x, vec2(0.0))), shadow)
    #include "eachFlatShadow"
    #ifdef CUBE_SHADOW_MAP
      #define VISIT_SHADOW(number, map, fromLight, shadow) READ(number, cubeShadow(map, (vec4(fromLight, 0.0) * viewMatrix).xyz, ShadowMapFacts(shadow.shadowBias, shadow.shadowRadius, shadow.shadowMapSize.x, vec2(shadow.shadowCameraNear, shadow.shadowCameraFar))), shadow)
      #include "eachCubeShadow"
    #endif // CUBE_SHADOW_MAP
  }
#endif // SEPARATES_SHADOWS
