// How shadows dissolve with the distance, along the light, from what casts them.
#if defined(TELLS_SHADOWS) && TONE_MODEL == TONE_MODEL_SHADOW
  #define DISSOLVES_SHADOWS

  uniform float shadowTone; // printed by a full shadow where it touches what casts it
  uniform float shadowFade; // share of the tone that is lost over the width that a shadow map covers

  #include "shadowMatrices"
  #include "shadowDepth"

  // The steps in which the distance is found: so many that no bands show.
  #define HALVINGS 7
  #define LAST_STEP (1.0 / 128.0)

  // What shadows take of each light, by its number, as three's chunk walks over them; and how much of the shadows is left.
  float shadowTakes[LIGHTS_WITH_DIRECTION];
  float shadowLeft = 1.0;

  // matrix: from the world to the map. at: the point in the map. toLight: unit, world space. radius: of the soft edge, as a share of the map.
  float leftOfFlat(
    FLAT_SHADOW_MAP map, const in mat4 matrix, const in vec4 at, const in vec3 toLight, const in float bias, const in vec2 radius
  ) {
    // The width that the map covers at this distance from the light is at.w over the length of this.
    vec4 row = vec4(matrix[0][0], matrix[1][0], matrix[2][0], 0.0);
    vec4 lastRow = vec4(matrix[0][3], matrix[1][3], matrix[2][3], 0.0);
    float reach = at.w / (length(row - 0.5 * lastRow) * shadowFade);
    vec4 towards = reach * (matrix * vec4(toLight, 0.0));
    #define PASSES(distance, away) passesFlat(map, at + (distance) * towards, (away) * radius, bias)
    #include "shadowSearch"
  }

  #ifdef CUBE_SHADOW_MAP
    // fromLight: to the point, world space. range: of the shadow's camera, near and far.
    float leftOfCube(
      CUBE_SHADOW_MAP map, const in vec3 fromLight, const in vec2 range, const in float bias, const in float radius
    ) {
      float lightDistance = length(fromLight);
      vec3 direction = fromLight / lightDistance;
      vec3 tangent = normalize(cross(direction, abs(direction.x) > abs(direction.z) ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
      mat2x3 aside = radius * mat2x3(tangent, cross(direction, tangent));
      vec3 onAxes = abs(fromLight);
      float reach = 2.0 * max(max(onAxes.x, onAxes.y), onAxes.z) / shadowFade;
      #define PASSES(distance, away) passesCube(map, direction + aside * (away), lightDistance - reach * (distance), range, bias)
      #include "shadowSearch"
    }
  #endif // CUBE_SHADOW_MAP

  // viewPosition: of the point, view space.
  void dissolveShadows(const in vec3 viewPosition) {
    float taken = 0.0;
    for (int i = 0; i < LIGHTS_WITH_DIRECTION; i++) taken += shadowTakes[i];
    if (!(taken > 0.0) || shadowFade == 0.0) return;
    float lost = 0.0;
    IncidentLight light;
    #define LOSE(number, left) if (shadowTakes[number] > 0.0) lost += shadowTakes[number] * (1.0 - left);
    #define VISIT_SHADOW(number, map, matrix, at, shadow) LOSE(number, leftOfFlat(map, matrix, at, (vec4(light.direction, 0.0) * viewMatrix).xyz, shadow.shadowBias, shadow.shadowRadius / shadow.shadowMapSize))
    #include "eachFlatShadow"
    #ifdef CUBE_SHADOW_MAP
      #define VISIT_SHADOW(number, map, at, shadow) LOSE(number, leftOfCube(map, at.xyz, vec2(shadow.shadowCameraNear, shadow.shadowCameraFar), shadow.shadowBias, shadow.shadowRadius / shadow.shadowMapSize.x))
      #include "eachCubeShadow"
    #endif // CUBE_SHADOW_MAP
    shadowLeft = 1.0 - lost / taken;
  }
#endif // TELLS_SHADOWS
