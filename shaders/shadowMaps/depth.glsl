// The light that passes a shadow map to a point at a depth. Most types of maps are compared here; a comparison sampler compares by itself.
#ifdef SHADOW_MAPS_COMPARE
  #define FLAT_SHADOW_MAP sampler2DShadow
  #define SHADOW_TEXEL(map, at, depth) texture(map, vec3(at, depth))
#else
  #define FLAT_SHADOW_MAP sampler2D
  #ifdef SHADOW_MOMENTS
    // The share of the depths around a place that lie beyond a depth. moments: mean and standard deviation of the depths.
    float passesMoments(const in vec2 moments, const in float depth) {
      #ifdef USE_REVERSED_DEPTH_BUFFER
        float beyond = moments.x - depth;
      #else
        float beyond = depth - moments.x;
      #endif // USE_REVERSED_DEPTH_BUFFER
      float variance = max(moments.y * moments.y, 1e-8);
      return beyond > 0.0 ? variance / (variance + beyond * beyond) : 1.0;
    }
    #define SHADOW_TEXEL(map, at, depth) passesMoments(SHADOW_MOMENTS(texture2D(map, at)), depth)
  #elif defined(USE_REVERSED_DEPTH_BUFFER)
    #define SHADOW_TEXEL(map, at, depth) step(SHADOW_DEPTH(texture2D(map, at)), depth)
  #else
    #define SHADOW_TEXEL(map, at, depth) step(depth, SHADOW_DEPTH(texture2D(map, at)))
  #endif // SHADOW_MOMENTS
#endif // SHADOW_MAPS_COMPARE

#ifdef USE_REVERSED_DEPTH_BUFFER
  #define BIASED(depth, bias) ((depth) - (bias))
#else
  #define BIASED(depth, bias) ((depth) + (bias))
#endif // USE_REVERSED_DEPTH_BUFFER

// What three.js tells of a shadow map.
struct ShadowMapFacts {
  float bias;
  float radius; // texels
  float texels; // per side
  vec2 range; // near and far of the camera of a cube
};

// at: homogeneous position in the map. Outside the map all light passes.
float passes(FLAT_SHADOW_MAP map, const in ShadowMapFacts facts, const in vec4 at, const in float depth) {
  vec2 place = at.xy / at.w;
  float there = SHADOW_TEXEL(map, place, BIASED(depth, facts.bias));
  return any(greaterThan(abs(place - 0.5), vec2(0.5))) ? 1.0 : there;
}

#ifdef CUBE_SHADOW_MAP
  // towards: direction, of any length. lightDistance: distance of the point. A face of the cube measures depth along its own axis.
  float passes(CUBE_SHADOW_MAP map, const in ShadowMapFacts facts, const in vec4 towards, const in float lightDistance) {
    vec3 direction = normalize(towards.xyz);
    vec3 onAxes = abs(direction);
    vec2 range = facts.range;
    float alongFace = max(lightDistance * max(max(onAxes.x, onAxes.y), onAxes.z), range.x);
    float depth = range.y * (1.0 - range.x / alongFace) / (range.y - range.x) + facts.bias;
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
