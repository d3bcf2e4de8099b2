// Pencil, charcoal, chalk: what a stroke leaves grows with its pressure, which is the tone, and catches on the tooth of the paper.
// The paper lies on the screen, so its field does too: it is blended with that of the strokes as fields are, and strokes move
// below it.
uniform sampler2D toothMap; // a standard normal field, low where the paper stands up (src/tam/toothMap.ts)
uniform vec2 toothOffset; // of this picture within a larger one, pixels
uniform float tooth;
uniform float toothSize; // pixels to a bump
uniform float softness;
uniform float smudge;

// What variance neighbouring texels of the map do not share.
#define TOOTH_UNSHARED (3.0 / 19.0)

// Grain as hard as its pixels would flicker.
#define LEAST_SOFTNESS 0.1

// Where bumps are so many pixels large, as in a print, smaller ones lie on them, as strong as this in the end: else one would see how
// the map is interpolated.
#define DETAIL_FROM 3.0
#define DETAIL_TO 9.0
#define DETAIL 0.6
#define DETAIL_FINER 3.7

// size: pixels to a bump.
float toothOf(const in float size) {
  vec2 texel = (gl_FragCoord.xy + toothOffset) / size * TOOTH_MAP_BUMP;
  float encoded = textureLod(toothMap, texel / TOOTH_MAP_SIZE, 0.0).r;
  // Gives back the variance that interpolation takes.
  vec2 between = fract(texel - 0.5);
  vec2 variance = 1.0 - 2.0 * between * (1.0 - between) * TOOTH_UNSHARED;
  return (6.0 * encoded - 3.0) * inversesqrt(variance.x * variance.y);
}

float toothField() {
  float detail = DETAIL * smoothstep(DETAIL_FROM, DETAIL_TO, toothSize);
  float coarse = toothOf(toothSize);
  if (detail == 0.0) return coarse;
  // At another size the map is as good as another one: variances add.
  return (coarse + detail * toothOf(toothSize / DETAIL_FINER)) * inversesqrt(1.0 + detail * detail);
}

// As the ink of a pen: the mean is the tone.
float inkAt(const in HatchField field, const in float tone, const in float crowding) {
  // What is rubbed in and what is drawn, printed over one another, are the tone.
  float blank = max(1.0 - tone, 1e-6);
  float rubbed = 1.0 - pow(blank, smudge);
  float drawn = 1.0 - pow(blank, 1.0 - smudge);

  float crowded = crowdedShare(crowding);
  vec2 shares = vec2((1.0 - tooth) * (1.0 - crowded), tooth);
  shares *= inversesqrt(max(dot(shares, shares), 1e-8));
  float g = dot(shares, vec2(field.g, toothField()));
  // Of the skew of one field, a sum keeps the cube of its share.
  float skew = field.mixing * shares.x * shares.x * shares.x;
  // An edge that went by the slope of the field would be wide where the field is steep: the mean would not be the tone.
  float left = darkenedFrom(unskew(normalDistribution(g).x, skew), drawn, max(softness, LEAST_SOFTNESS));
  // Without a tooth, crowded strokes leave nothing but their tone.
  left = mix(left, drawn, crowded * (1.0 - tooth));
  return 1.0 - (1.0 - rubbed) * (1.0 - left);
}
