// The four comparisons that a comparison sampler would make.
{
  vec2 texel = shadowCoord.xy * shadowMapSize - 0.5;
  vec2 share = fract(texel);
  ivec2 corner = ivec2(floor(texel));
  ivec2 last = ivec2(shadowMapSize) - 1;
  vec4 depths = vec4(
    texelFetch(shadowMap, clamp(corner, ivec2(0), last), 0).r,
    texelFetch(shadowMap, clamp(corner + ivec2(1, 0), ivec2(0), last), 0).r,
    texelFetch(shadowMap, clamp(corner + ivec2(0, 1), ivec2(0), last), 0).r,
    texelFetch(shadowMap, clamp(corner + 1, ivec2(0), last), 0).r
  );
  #ifdef USE_REVERSED_DEPTH_BUFFER
    vec4 lit = step(depths, vec4(shadowCoord.z));
  #else
    vec4 lit = step(vec4(shadowCoord.z), depths);
  #endif // USE_REVERSED_DEPTH_BUFFER
  shadow = mix(mix(lit.x, lit.y, share.x), mix(lit.z, lit.w, share.x), share.y);
}
