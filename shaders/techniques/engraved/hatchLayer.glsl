// Engraved lines: level sets of a function on the object. They never break, fork or repeat, on any mesh. They swell with the
// tone, new ones are born between old ones as one comes nearer, and other families cross them in the darks.
uniform float crossFrom; // tone above which lines cross
uniform float screenConstancy; // 0: lines spaced on the object, 1: on the screen

#include "crossedTones"
#include "technique/fieldAxis"
#include "technique/hand"
#include "technique/ruledLines"

// Where the surface leans less than this across the gradient of the first family, sines of the angle, it has no lines left, and
// those that cross it take its tone.
#define BARE_SLOPE vec2(0.06, 0.18)

float hatchLayer(const in HatchingParameters h, const in float tone) {
  Field field = firstField(h.toLight, h.bend);
  vec3 waves = slowWaves(3.5 * h.point);
  vec3 point = handPoint(h.point, waves);
  float pressure = handPressure(waves);
  ScreenMap onScreen = screenMap(h.normal);
  vec3 gradient;
  float value = fieldAt(field, point, gradient);

  // Of two axes across the first, the one whose lines run better across its lines on the surface. The other fades out as it
  // comes to run along them.
  vec3 sideB = across(field.axis);
  vec3 sideC = cross(field.axis, sideB);
  float slope = length(cross(h.normal, gradient));
  float has = smoothstep(BARE_SLOPE.x, BARE_SLOPE.y, slope);
  float acrossB = dot(h.normal, sideC);
  float acrossC = dot(h.normal, sideB);
  float between = (acrossB * acrossB - acrossC * acrossC) / max(slope * slope, 1e-4);
  float shareB = mix(1.0, smoothstep(-0.35, 0.35, between), has);

  // What stays blank in each family, so that printed over one another, Π (1 − Tᵢ), they leave as much blank as the tone does.
  float first = has * takenOf(tone, crossFrom);
  float rest = 1.0 - leftOf(tone, first);
  float blankB = mix(1.0, rest, shareB);
  float blankC = rest / max(blankB, 1e-4);

  // Families without ink cost nothing: the one that takes more comes first.
  bool isB = shareB >= 0.5;
  float blankSecond = isB ? blankB : blankC;
  float blankThird = isB ? blankC : blankB;
  int count = tone >= 1.0 || tone <= 0.0 ? 0 : blankThird < 0.9999 ? 3 : blankSecond < 0.9999 ? 2 : 1;
  vec2 across1 = screenGradient(gradient, onScreen);
  float blank = tone >= 1.0 ? 0.0 : 1.0;
  for (int i = 0; i < count; i++) {
    vec3 side = (i == 1) == isB ? sideB : sideC;
    vec2 mixing = i == 0 ? vec2(1.0, 0.0) : vec2(cos(crossAngle), sin(crossAngle));
    float perPixel = length(mixing.x * across1 + mixing.y * screenGradient(side, onScreen));
    float taken = i == 0 ? first : 1.0 - (i == 1 ? blankSecond : blankThird);
    float along = mixing.x * value + mixing.y * dot(point, side);
    blank *= 1.0 - ruledLines(along, max(perPixel, 1e-12), i == 0 ? max(slope, 1e-6) : 1.0, handTone(pressure, taken));
  }
  return 1.0 - blank;
}
