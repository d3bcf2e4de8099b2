// Shadows whose edges widen and whose tone dissolves with the distance from the occluder.
#if defined(SEPARATES_SHADOWS) && TONE_MODEL == TONE_MODEL_SHADOW
  #define DISSOLVES_SHADOWS

  uniform float shadowTone; // tone of a full shadow where it touches its occluder
  uniform float shadowFade; // share of the tone that is lost over the width of the shadow map
  uniform float shadowSoftness; // width of the edge, as a share of the distance from the occluder

  #include "shadowMatrices"
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
    vec3 side; // unit vector across the light, as is `up`
    vec3 up;
  };

  Rays raysTo(const in vec3 toLight, const in float width) {
    vec3 side = normalize(cross(toLight, abs(toLight.y) < OVERHEAD ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    return Rays(width / max(shadowFade, 1.0 / FARTHEST_CASTER), width, 0.0, side, cross(toLight, side));
  }

  // matrix: from world to map. point: world space. toLight: unit, world space. Returns the light that passes and the share of the tone that
  // is left.
  vec2 flatShadow(
    FLAT_SHADOW_MAP map, const in mat4 matrix, const in vec3 point, const in vec3 toLight, const in float bias, const in float radius,
    const in float texels
  ) {
    vec4 at = matrix * vec4(point, 1.0);
    if (at.w <= 0.0 || any(greaterThan(abs(at.xyz / at.w - 0.5), vec3(0.5)))) return vec2(1.0);
    // The width of the map across the light at this distance is at.w divided by the length of this vector.
    vec4 row = vec4(matrix[0][0], matrix[1][0], matrix[2][0], 0.0);
    vec4 lastRow = vec4(matrix[0][3], matrix[1][3], matrix[2][3], 0.0);
    Rays rays = raysTo(toLight, at.w / length(row - 0.5 * lastRow));
    vec4 towards = matrix * vec4(toLight, 0.0);
    rays.nearing = max(-towards.w / at.w, 0.0);
    mat2x4 across = mat2x4(matrix * vec4(rays.side, 0.0), matrix * vec4(rays.up, 0.0));
    #define MAP_PLACE vec4
    #define PLACE(distance) (at + (distance) * towards)
    #define DEPTH(distance) (at.z + (distance) * towards.z) / (at.w + (distance) * towards.w)
    #define PASSES(place, depth) passesFlat(map, place, BIASED(depth, bias))
    #include "shadowSearch"
  }

  #ifdef CUBE_SHADOW_MAP
    // fromLight: vector to the point, world space. range: near and far of the shadow camera.
    vec2 cubeShadow(
      CUBE_SHADOW_MAP map, const in vec3 fromLight, const in vec2 range, const in float bias, const in float radius, const in float texels
    ) {
      vec3 onAxes = abs(fromLight);
      float lightDistance = length(fromLight);
      vec3 toLight = -fromLight / lightDistance;
      Rays rays = raysTo(toLight, 2.0 * max(max(onAxes.x, onAxes.y), onAxes.z));
      rays.nearing = 1.0 / lightDistance;
      mat2x3 across = mat2x3(rays.side, rays.up);
      #define MAP_PLACE vec3
      #define PLACE(distance) (fromLight + (distance) * toLight)
      #define DEPTH(distance) lightDistance - (distance)
      #define PASSES(place, depth) passesCube(map, place, depth, range, bias)
      #include "shadowSearch"
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
    #define VISIT_SHADOW(number, map, matrix, shadow) READ(number, flatShadow(map, matrix, point, (vec4(light.direction, 0.0) * viewMatrix).xyz, shadow.shadowBias, shadow.shadowRadius, shadow.shadowMapSize.x), shadow)
    #include "eachFlatShadow"
    #ifdef CUBE_SHADOW_MAP
      #define VISIT_SHADOW(number, map, fromLight, shadow) READ(number, cubeShadow(map, (vec4(fromLight, 0.0) * viewMatrix).xyz, vec2(shadow.shadowCameraNear, shadow.shadowCameraFar), shadow.shadowBias, shadow.shadowRadius, shadow.shadowMapSize.x), shadow)
      #include "eachCubeShadow"
    #endif // CUBE_SHADOW_MAP
  }
#endif // SEPARATES_SHADOWS
