import { ShaderChunk } from 'three';

/** How many samples on each side of the middle a soft edge takes at most. */
const MOST_SAMPLES = '4.0';

/**
 * Functions of the steady kernel. A sample of a comparing sampler is the bilinear mean of four comparisons, so samples no more
 * than a texel apart give an edge without steps; they are weighted as a tent.
 */
const STEADY_KERNEL = `
int samplesAside(const in float radius) {
  return int(clamp(ceil(radius), 0.0, ${MOST_SAMPLES}));
}

float tentWeight(const in int x, const in int y, const in int n) {
  float span = float(n + 1);
  return (span - abs(float(x))) * (span - abs(float(y))) / (span * span * span * span);
}
`;

const STEADY_FLAT = `
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
`;

/**
 * Every sample is compared with the depth of the point beside the fragment in its direction, as a face of the cube keeps it: along
 * its own axis.
 */
const STEADY_CUBE = `
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
      #endif
      shadow += tentWeight(x, y, n) * texture(shadowMap, vec4(direction, depth));
    }
  }
}
`;

/** Without a comparing sampler: the four comparisons that it would make. */
const BILINEAR_FLAT = `
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
  #endif
  shadow = mix(mix(lit.x, lit.y, share.x), mix(lit.z, lit.w, share.x), share.y);
}
`;

/** The same on a face of a cube, whose texels lie in rows along the two axes other than the face's own. */
const BILINEAR_CUBE = `
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
  #endif
  vec4 lit = step(vec4(dp), depths);
  shadow = mix(mix(lit.x, lit.y, share.x), mix(lit.z, lit.w, share.x), share.y);
}
`;

/** What of three's chunk is replaced, and by what. Each stands in it once. */
const REPLACEMENTS: readonly (readonly [RegExp, string])[] = [
  [
    /float phi = interleavedGradientNoise\([^;]*;[^\n]*\s*shadow = \(\s*texture\( shadowMap, vec3\([^;]*\) \* 0\.2;/,
    STEADY_FLAT,
  ],
  [/float phi = interleavedGradientNoise\([^;]*;[^#]*?bd3D[^#]*?\*=? 0\.2;/, STEADY_CUBE],
  [
    /float depth = texture2D\( shadowMap, shadowCoord\.xy \)\.r;\s*#ifdef USE_REVERSED_DEPTH_BUFFER\s*shadow = step\( depth, shadowCoord\.z \);\s*#else\s*shadow = step\( shadowCoord\.z, depth \);\s*#endif/,
    BILINEAR_FLAT,
  ],
  [
    /float depth = textureCube\( shadowMap, bd3D \)\.r;\s*#ifdef USE_REVERSED_DEPTH_BUFFER\s*depth = 1\.0 - depth;\s*#endif\s*shadow = step\( dp, depth \);/,
    BILINEAR_CUBE,
  ],
];

/**
 * three's own functions of shadow maps, but for the filter: three turns its samples by noise that belongs to the screen, which
 * strokes would show as a ragged edge that crawls under a moving camera. What a version words otherwise, as those before 0.182
 * do, and what someone has put in three's place, stays.
 */
export function shadowMapsChunk(source = ShaderChunk.shadowmap_pars_fragment): string {
  const steady = REPLACEMENTS.reduce((text, [pattern, replacement]) => text.replace(pattern, replacement), source);
  if (steady === source) return source;
  return `#if defined(USE_SHADOWMAP) && defined(SHADOWMAP_TYPE_PCF)\n${STEADY_KERNEL}#endif\n${steady}`;
}
