// Pencil, charcoal, chalk: the darkness of a stroke grows with its pressure, which is the tone, and depends on the tooth of the paper.
// Paper is fixed to the screen, so strokes move below its grain. The field of the paper and that of the strokes are blended as any two
// fields are.
#include "tooth"

uniform float paperGrain;
uniform float softness;
uniform float smudge;

// Grain with edges as sharp as a pixel would flicker.
#define LEAST_SOFTNESS 0.1
// The shares by which tooth and smudge decrease up to full tone, where the hand presses harder.
#define PRESSED vec2(0.5, 0.25)

// The darkness ∈ [0, 1] of a dry medium for a field and a tone. As with ink, its mean is the tone.
float inkAt(const in HatchField field, const in float tone, const in float crowding) {
  // With tooth 1, grain is not reduced.
  vec2 pressed = 1.0 - PRESSED * tone * tone * vec2(1.0 - paperGrain, 1.0);
  // A smudged tone and a drawn one, printed over one another, give the tone.
  float blank = max(1.0 - tone, 1e-6);
  float share = smudge * pressed.y;
  float rubbed = 1.0 - pow(blank, share);
  float drawn = 1.0 - pow(blank, 1.0 - share);

  float crowded = crowdedShare(crowding);
  float grain = paperGrain * pressed.x;
  vec2 shares = vec2((1.0 - grain) * (1.0 - crowded), grain);
  shares *= inversesqrt(max(dot(shares, shares), 1e-8));
  float g = dot(shares, vec2(field.g, toothField()));
  // The skew of a sum is that of one field times the cube of its share.
  float skew = field.mixing * shares.x * shares.x * shares.x;
  // The edge has a fixed width: one that depends on the slope of the field would be too wide where the field is steep, and shift the mean.
  float left = darkenedFrom(unskew(normalDistribution(g).x, skew), drawn, max(softness, LEAST_SOFTNESS));
  // Without tooth, crowded strokes become a flat tone.
  left = mix(left, drawn, crowded * (1.0 - grain));
  return 1.0 - (1.0 - rubbed) * (1.0 - left);
}
