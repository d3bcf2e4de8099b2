// Lines cut by a field: level sets of a distance in space.
#include "technique/fieldAxis"
#include "technique/fieldAtFragment"

struct HatchingParameters {
  vec3 point; // position from the origin of the field, displaced by the hand, tiles
  float pressure; // of the hand
  mat2x3 onScreen, triangle; // of the smooth surface, and of the flat triangle
  float value; // of the first family's function
  vec2 valueOnScreen; // its gradient there
  float slope; // its change along the surface
  float firstShare; // share to which the first family has lines here
  vec3 sideB, sideC; // perpendicular to its axis; other families lean towards one of them
  vec3 gradient; // of the first family's function, unit
  float shareB; // share of family B in the crossing tone, by how well its lines cross those of the first on the surface
};

HatchingParameters readHatchingParameters() {
  HatchingParameters h;
  Field field = fieldAtFragment(h.sideB);
  vec3 normal = safeNormalize(vFieldNormal);
  vec3 waves = slowWaves(HAND_WAVES * vFieldPoint);
  h.point = handPoint(vFieldPoint, waves);
  h.pressure = handPressure(waves);
  h.onScreen = smoothOnScreen();
  h.triangle = triangleOnScreen();
  h.value = fieldAt(field, h.point, h.gradient);
  h.valueOnScreen = screenGradient(h.gradient, h.onScreen);
  float along = dot(normal, h.gradient);
  h.slope = sqrt(max(1.0 - along * along, 1e-12));
  h.firstShare = smoothstep(BARE_SLOPE.x, BARE_SLOPE.y, h.slope);
  h.sideC = cross(field.axis, h.sideB);
  float acrossB = dot(normal, h.sideC);
  float acrossC = dot(normal, h.sideB);
  float between = (acrossB * acrossB - acrossC * acrossC) / max(h.slope * h.slope, 1e-4);
  h.shareB = mix(1.0, smoothstep(-SIDE_FADE, SIDE_FADE, between), h.firstShare);
  return h;
}

Family firstFamily(const in HatchingParameters h) {
  float trianglePerPixel = length(screenGradient(h.gradient, h.triangle));
  return Family(h.value, length(h.valueOnScreen), trianglePerPixel, min(h.slope / SPARSEST_SLOPE, 1.0), h.gradient, ANY_OCTAVE);
}

// isB: the side towards which it leans. lean: cosine and sine of the angle at which it crosses the first.
Family crossingFamily(const in HatchingParameters h, const in bool isB, const in vec2 lean) {
  vec3 side = isB ? h.sideB : h.sideC;
  float perPixel = length(lean.x * h.valueOnScreen + lean.y * screenGradient(side, h.onScreen));
  vec3 gradient = lean.x * h.gradient + lean.y * side;
  float trianglePerPixel = length(screenGradient(gradient, h.triangle));
  return Family(lean.x * h.value + lean.y * dot(h.point, side), perPixel, trianglePerPixel, 1.0, gradient, ANY_OCTAVE);
}

vec2 fieldUv(const in HatchingParameters h) {
  return vec2(dot(h.point, h.sideB), h.value);
}
