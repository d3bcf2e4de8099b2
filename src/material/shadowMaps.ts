import { ShaderChunk } from 'three';

/** How many samples on each side of the middle a soft edge takes at most. */
const MOST_SAMPLES = 4;

/**
 * Functions of the steady kernel. A sample of a comparing sampler is the bilinear mean of four comparisons, so samples no more
 * than a texel apart give an edge without steps; they are weighted as a tent.
 */
const STEADY_KERNEL = `
int samplesAside(const in float radius) {
  return int(clamp(ceil(radius), 0.0, ${MOST_SAMPLES.toFixed(1)}));
}

float tentWeight(const in int x, const in int y, const in int n) {
  float span = float(n + 1);
  return (span - abs(float(x))) * (span - abs(float(y))) / (span * span * span * span);
}
`;

const STEADY_FLAT = `
int n = samplesAside(shadowRadius);
vec2 away = n == 0 ? vec2(0.0) : radius / float(n);
shadow = 0.0;
for (int y = -n; y <= n; y++) {
  for (int x = -n; x <= n; x++) {
    shadow += tentWeight(x, y, n) * texture(shadowMap, vec3(shadowCoord.xy + vec2(x, y) * away, shadowCoord.z));
  }
}
`;

const STEADY_CUBE = `
int n = samplesAside(shadowRadius);
float away = n == 0 ? 0.0 : texelSize / float(n);
shadow = 0.0;
for (int y = -n; y <= n; y++) {
  for (int x = -n; x <= n; x++) {
    vec3 direction = bd3D + (tangent * float(x) + bitangent * float(y)) * away;
    vec3 absDirection = abs(direction);
    float dp = depthA + depthB / max(max(absDirection.x, absDirection.y), absDirection.z);
    shadow += tentWeight(x, y, n) * texture(shadowMap, vec4(direction, dp));
  }
}
`;

/** Without a comparing sampler: the four comparisons that it would make. */
const BILINEAR_FLAT = `
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
`;

/** What of three's chunk is replaced, and by what. Each stands in it once. */
const REPLACEMENTS: readonly (readonly [RegExp, string])[] = [
  [
    /float phi = interleavedGradientNoise\([^;]*;\s*shadow = \(\s*texture\( shadowMap, vec3\([^;]*\) \* 0\.2;/,
    STEADY_FLAT,
  ],
  [
    /float phi = interleavedGradientNoise\([^;]*;\s*shadow = 0\.0;\s*for \( int i = 0; i < 5; i \+\+ \) \{[^}]*\}\s*shadow \*= 0\.2;/,
    STEADY_CUBE,
  ],
  [
    /float depth = texture2D\( shadowMap, shadowCoord\.xy \)\.r;\s*#ifdef USE_REVERSED_DEPTH_BUFFER\s*shadow = step\( depth, shadowCoord\.z \);\s*#else\s*shadow = step\( shadowCoord\.z, depth \);\s*#endif/,
    BILINEAR_FLAT,
  ],
];

/**
 * three's own functions of shadow maps, but for the filter: three turns its samples by noise that belongs to the screen, which
 * strokes would show as a ragged edge that crawls under a moving camera. Where a version words them otherwise, as those before
 * 0.182 do, and where someone has put something else in three's place, that stays.
 */
export function shadowMapsChunk(source = ShaderChunk.shadowmap_pars_fragment): string {
  if (!REPLACEMENTS.every(([pattern]) => pattern.test(source))) return source;
  const steady = REPLACEMENTS.reduce((text, [pattern, replacement]) => text.replace(pattern, replacement), source);
  return `#if defined(USE_SHADOWMAP) && defined(SHADOWMAP_TYPE_PCF)\n${STEADY_KERNEL}#endif\n${steady}`;
}
