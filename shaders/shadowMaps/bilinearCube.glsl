// The four comparisons on a face of a cube map, whose texels lie in rows along the two axes that are not the face's own.
{
  vec3 own = absVec.x == viewSpaceZ ? vec3(1.0, 0.0, 0.0) : absVec.y == viewSpaceZ ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
  vec3 row = own.x == 1.0 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
  vec3 column = 1.0 - own - row;
  vec3 onFace = lightToPosition / viewSpaceZ;
  vec3 texel = (0.5 * onFace + 0.5) * shadowMapSize.x - 0.5;
  vec2 share = vec2(dot(fract(texel), row), dot(fract(texel), column));
  float width = 2.0 / shadowMapSize.x;
  vec3 corner = mix((floor(texel) + 0.5) * width - 1.0, onFace, own);
  vec4 depths = vec4(
    texture(shadowMap, corner).r,
    texture(shadowMap, corner + width * row).r,
    texture(shadowMap, corner + width * column).r,
    texture(shadowMap, corner + width * (row + column)).r
  );
  #ifdef USE_REVERSED_DEPTH_BUFFER
    depths = 1.0 - depths;
  #endif // USE_REVERSED_DEPTH_BUFFER
  vec4 lit = step(vec4(dp), depths);
  shadow = mix(mix(lit.x, lit.y, share.x), mix(lit.z, lit.w, share.x), share.y);
}
