// What engraving needs to know at this fragment: the function that lines are level sets of, and how it lies on the surface and
// on the screen.
#include "perFragment/viewToAnchor"

uniform mat3 objectToField; // linear part

#include "technique/fieldAxis"
#include "technique/arrivingLight"
#include "technique/hand"
#include "perFragment/screenGradient"

// Where the surface leans less than this across the gradient of the first family, sines of the angle, it has no lines left, and
// those that cross it take its tone.
#define BARE_SLOPE vec2(0.06, 0.18)

// Units of the slow waves of a hand to a tile.
#define HAND_WAVES 3.5
// How far from evenly matched the two crossing families share a place: the difference of their squared sines.
#define SIDE_FADE 0.35

struct HatchingParameters {
  vec3 point; // as the hand strays, from the origin of the field, tiles
  float pressure; // of the hand
  ScreenMap onScreen;
  float value; // of the first family's function
  vec2 valueOnScreen; // its gradient there
  float slope; // its change along the surface
  float has; // how far the first family has lines
  vec3 sideB, sideC; // across its axis; other families lean towards one of them
  vec3 alongFirst; // the place by those two, and how much more the first of them changes along its lines
  float shareB; // of what crosses, by how well its lines run across those of the first on the surface
};

HatchingParameters readHatchingParameters() {
  Field field = firstField(arrivingLight());
  HatchingParameters h;
  vec3 normal = safeNormalize(vFieldNormal);
  vec3 waves = slowWaves(HAND_WAVES * vFieldPoint);
  h.point = handPoint(vFieldPoint, waves);
  h.pressure = handPressure(waves);
  h.onScreen = screenMap(normal, objectToField * readViewToAnchor());
  vec3 gradient;
  h.value = fieldAt(field, h.point, gradient);
  h.valueOnScreen = screenGradient(gradient, h.onScreen);
  h.slope = max(length(cross(normal, gradient)), 1e-6);
  h.has = smoothstep(BARE_SLOPE.x, BARE_SLOPE.y, h.slope);
  h.sideB = across(field.axis);
  h.sideC = cross(field.axis, h.sideB);
  float acrossB = dot(normal, h.sideC);
  float acrossC = dot(normal, h.sideB);
  float between = (acrossB * acrossB - acrossC * acrossC) / max(h.slope * h.slope, 1e-4);
  float shareB = smoothstep(-SIDE_FADE, SIDE_FADE, between);
  h.alongFirst = vec3(dot(h.point, h.sideB), dot(h.point, h.sideC), shareB);
  h.shareB = mix(1.0, shareB, h.has);
  return h;
}
