// Pencil, charcoal, chalk: what a stroke leaves grows with its pressure, which is the tone, and catches on the tooth of the paper.
// The paper lies on the screen, and its field with it: strokes move below the grain. The field of the paper and that of the strokes are
// blended as any two fields are.
#include "tooth"

uniform float tooth;
uniform float softness;
uniform float smudge;

// Grain whose edges are as hard as a pixel would flicker.
#define LEAST_SOFTNESS 0.1
// In the darks the hand presses: at full tone up to so much less of the tooth counts, and so much less is smudged.
#define PRESSED vec2(0.5, 0.25)

// What a dry medium leaves ∈ [0, 1], of a field under a tone. As with ink, its mean is the tone.
float inkAt(const in HatchField field, const in float tone, const in float crowding) {
  // What is nothing but grain stays so.
  vec2 pressed = 1.0 - PRESSED * tone * tone * vec2(1.0 - tooth, 1.0);
  // A smudged tone and a drawn one, printed over one another, give the tone.
  float blank = max(1.0 - tone, 1e-6);
  float share = smudge * pressed.y;
  float rubbed = 1.0 - pow(blank, share);
  float drawn = 1.0 - pow(blank, 1.0 - share);

  float crowded = crowdedShare(crowding);
  float grain = tooth * pressed.x;
  vec2 shares = vec2((1.0 - grain) * (1.0 - crowded), grain);
  shares *= inversesqrt(max(dot(shares, shares), 1e-8));
  float g = dot(shares, vec2(field.g, toothField()));
  // Of the skew of one field, a sum keeps the cube of its share.
  float skew = field.mixing * shares.x * shares.x * shares.x;
  // An edge that went by the slope of the field would be wide where the field is steep: the mean would not be the tone.
  float left = darkenedFrom(unskew(normalDistribution(g).x, skew), drawn, max(softness, LEAST_SOFTNESS));
  // Without a tooth, crowded strokes leave nothing but their tone.
  left = mix(left, drawn, crowded * (1.0 - grain));
  return 1.0 - (1.0 - rubbed) * (1.0 - left);
}
