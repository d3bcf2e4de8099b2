// Engraved lines: level sets of a function on the object. They never break, fork or repeat, on any mesh. They swell with the
// tone, new ones are born between old ones as one comes nearer, and other families cross them in the darks.
uniform float strokeScale; // tiles per object unit
uniform float crossFrom; // tone above which lines cross
uniform float screenConstancy; // 0: lines spaced on the object, 1: on the screen

#include "technique/fieldAxis"
#include "technique/hand"
#include "technique/ruledLines"

// How much of the tone above `crossFrom` the first family still takes.
#define FIRST_SHARE 0.4

// The darkness of one family: the level sets of the place along `axis`. point: as the hand strays, pressure: of the hand.
float family(
  const in vec3 point, const in ScreenMap onScreen, const in float pressure, const in vec3 axis, const in float tone
) {
  if (tone <= 0.0) return 0.0;
  return ruledLines(dot(point, axis), max(screenGradient(axis, onScreen), 1e-12), handTone(pressure, tone));
}

// How far the lines of two axes cross on the surface: the sine of their angle.
float acrossness(const in vec3 a, const in vec3 b, const in vec3 n) {
  vec3 ta = a - n * dot(n, a);
  vec3 tb = b - n * dot(n, b);
  return abs(dot(n, cross(ta, tb))) * inversesqrt(max(dot(ta, ta) * dot(tb, tb), 1e-12));
}

float hatchLayer(const in HatchingParameters h, const in float tone) {
  vec3 axis = fieldAxis(h.toLight);
  // What each family takes, so that printed over one another, 1 − Π (1 − Tᵢ), they give the tone again.
  float above = max(tone - crossFrom, 0.0);
  float first = min(tone, crossFrom) + FIRST_SHARE * above;
  float rest = 1.0 - (1.0 - tone) / max(1.0 - first, 1e-4);
  // On any surface one of two axes across the first runs well across it. The other fades out as it comes to run along it.
  vec3 side = across(axis);
  vec3 b = cos(crossAngle) * axis + sin(crossAngle) * side;
  vec3 c = cos(crossAngle) * axis + sin(crossAngle) * cross(axis, side);
  float sb = acrossness(axis, b, h.normal);
  float sc = acrossness(axis, c, h.normal);
  float share = smoothstep(-0.35, 0.35, sb * sb - sc * sc);
  float blank = max(1.0 - rest, 1e-4);
  // What all families share, once.
  vec3 point = handPoint(h.point);
  float pressure = handPressure(h.point);
  ScreenMap onScreen = screenMap(h.normal);
  float darkness = 1.0 - (1.0 - family(point, onScreen, pressure, axis, first))
    * (1.0 - family(point, onScreen, pressure, b, 1.0 - pow(blank, share)))
    * (1.0 - family(point, onScreen, pressure, c, 1.0 - pow(blank, 1.0 - share)));
  return tone >= 1.0 ? 1.0 : darkness;
}
