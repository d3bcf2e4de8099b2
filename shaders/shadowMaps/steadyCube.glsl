// Replaces three.js' five noisy samples of a cube map. Each sample is compared with the depth of a point in its direction, as far from the
// light as the fragment. A face of the cube measures depth along its own axis.
{
  int n = samplesAside(shadowRadius);
  float away = n == 0 ? 0.0 : texelSize / float(n);
  float lightDistance = length(lightToPosition);
  float depthRange = shadowCameraFar - shadowCameraNear;
  shadow = 0.0;
  for (int y = -n; y <= n; y++) {
    for (int x = -n; x <= n; x++) {
      vec3 direction = bd3D + (tangent * float(x) + bitangent * float(y)) * away;
      vec3 absDirection = abs(direction);
      float alongFace = lightDistance * max(max(absDirection.x, absDirection.y), absDirection.z);
      #ifdef USE_REVERSED_DEPTH_BUFFER
        float depth = shadowCameraNear * (shadowCameraFar / alongFace - 1.0) / depthRange - shadowBias;
      #else
        float depth = shadowCameraFar * (1.0 - shadowCameraNear / alongFace) / depthRange + shadowBias;
      #endif // USE_REVERSED_DEPTH_BUFFER
      shadow += tentWeight(x, y, n) * texture(shadowMap, vec4(direction, depth));
    }
  }
}
