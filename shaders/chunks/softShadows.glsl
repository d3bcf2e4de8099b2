// Shadows alone: their edges widen, and their tone dissolves, with the distance from what casts them.
#if defined(TELLS_SHADOWS) && TONE_MODEL == TONE_MODEL_SHADOW
  #define DISSOLVES_SHADOWS

  uniform float shadowTone; // printed by a full shadow where it touches what casts it
  uniform float shadowFade; // share of the tone that is lost over the width that a shadow map covers
  uniform float shadowSoftness; // width of the edge, as a share of the distance from what casts it

  #include "shadowMatrices"
  #include "shadowDepth"

  // The steps in which the distance is found: so many that no bands show.
  #define HALVINGS 6
  #define LAST_STEP (1.0 / 64.0)
  // Rays are taken up at this share of their length, where a surface that leans to the light does not meet them.
  #define WITHIN 0.25

  // Of each light, by its number: how much of it passes, below 0 where three's function has to tell, and what is left of the tone.
  float passing[LIGHTS_WITH_DIRECTION];
  float toneLeft[LIGHTS_WITH_DIRECTION];
  // What shadows take of all lights, and how much of that has dissolved.
  float shadowTaken = 0.0;
  float shadowLost = 0.0;

  // How much of the tone of all shadows is left.
  float shadowLeft() {
    return shadowTaken > 0.0 ? 1.0 - shadowLost / shadowTaken : 1.0;
  }

  // Rays from a point to places on a lamp.
  struct Rays {
    float farthest; // distance at which what casts a shadow is looked for, in world units
    float width; // that the map covers at the point
    float nearing; // one over the distance of a lamp, 0 for a sun
    vec3 side; // across the light, unit; and so is `up`
    vec3 up;
  };

  Rays raysTo(const in vec3 toLight, const in float width) {
    vec3 side = normalize(cross(toLight, abs(toLight.y) < OVERHEAD ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    return Rays(width / max(shadowFade, 1.0 / FARTHEST_CASTER), width, 0.0, side, cross(toLight, side));
  }

  // matrix: from the world to the map. point: world space. toLight: unit, the same. Gives what passes, and what is left.
  vec2 flatShadow(
    FLAT_SHADOW_MAP map, const in mat4 matrix, const in vec3 point, const in vec3 toLight, const in float bias, const in float radius,
    const in float texels
  ) {
    vec4 at = matrix * vec4(point, 1.0);
    if (at.w <= 0.0 || any(greaterThan(abs(at.xyz / at.w - 0.5), vec3(0.5)))) return vec2(1.0);
    // What the map covers across the light is as wide, at this distance, as at.w over the length of this.
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
    // fromLight: to the point, world space. range: of the shadow's camera, near and far.
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

  // viewPosition: of the point, view space. Before three's chunk walks over the lights.
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
#endif // TELLS_SHADOWS
