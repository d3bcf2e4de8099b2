// Pencil, charcoal, chalk: what a stroke leaves grows with its pressure, which is the tone, and catches on the tooth of the paper.
// The paper lies on the screen, so its field does too: it is blended with that of the strokes as fields are, and strokes move
// below it.
#include "tooth"

uniform float tooth;
uniform float softness;
uniform float smudge;

// Grain as hard as its pixels would flicker.
#define LEAST_SOFTNESS 0.1

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
