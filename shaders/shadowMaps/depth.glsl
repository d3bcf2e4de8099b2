// How much light passes a shadow map to a point beyond a depth. Most types of maps are read; a comparing one does it itself.
#ifdef SHADOW_MAPS_COMPARE
  #define FLAT_SHADOW_MAP sampler2DShadow
  #define SHADOW_TEXEL(map, at, depth) texture(map, vec3(at, depth))
#else
  #define FLAT_SHADOW_MAP sampler2D
  #ifdef USE_REVERSED_DEPTH_BUFFER
    #define SHADOW_TEXEL(map, at, depth) step(SHADOW_DEPTH(texture2D(map, at)), depth)
  #else
    #define SHADOW_TEXEL(map, at, depth) step(depth, SHADOW_DEPTH(texture2D(map, at)))
  #endif // USE_REVERSED_DEPTH_BUFFER
#endif // SHADOW_MAPS_COMPARE

#ifdef USE_REVERSED_DEPTH_BUFFER
  #define BIASED(depth, bias) ((depth) - (bias))
#else
  #define BIASED(depth, bias) ((depth) + (bias))
#endif // USE_REVERSED_DEPTH_BUFFER

// at: with w. away: as a share of the map.
float passesFlat(FLAT_SHADOW_MAP map, const in vec4 at, const in vec2 away, const in float bias) {
  vec3 place = at.xyz / at.w;
  return SHADOW_TEXEL(map, place.xy + away, BIASED(place.z, bias));
}

#ifdef CUBE_SHADOW_MAP
  // lightDistance: of the point. A face of the cube measures depth along its own axis.
  float passesCube(
    CUBE_SHADOW_MAP map, const in vec3 direction, const in float lightDistance, const in vec2 range, const in float bias
  ) {
    vec3 onAxes = abs(direction);
    float alongFace = max(lightDistance * max(max(onAxes.x, onAxes.y), onAxes.z), range.x);
    float depth = range.y * (1.0 - range.x / alongFace) / (range.y - range.x) + bias;
    #ifdef SHADOW_MAPS_COMPARE
      #ifdef USE_REVERSED_DEPTH_BUFFER
        depth = 1.0 - depth;
      #endif // USE_REVERSED_DEPTH_BUFFER
      return texture(map, vec4(direction, depth));
    #else
      float nearest = textureCube(map, direction).r;
      #ifdef USE_REVERSED_DEPTH_BUFFER
        nearest = 1.0 - nearest;
      #endif // USE_REVERSED_DEPTH_BUFFER
      return step(depth, nearest);
    #endif // SHADOW_MAPS_COMPARE
  }
#endif // CUBE_SHADOW_MAP
