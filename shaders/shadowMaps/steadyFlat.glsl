// Replaces three.js' five noisy samples of a flat shadow map.
{
  int n = samplesAside(shadowRadius);
  vec2 away = n == 0 ? vec2(0.0) : shadowRadius / float(n) / shadowMapSize;
  shadow = 0.0;
  for (int y = -n; y <= n; y++) {
    for (int x = -n; x <= n; x++) {
      shadow += tentWeight(x, y, n) * texture(shadowMap, vec3(shadowCoord.xy + vec2(x, y) * away, shadowCoord.z));
    }
  }
}
