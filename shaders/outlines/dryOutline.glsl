// Outlines of pencil, charcoal and chalk: they catch on the tooth of the paper, most at their sides, where the hand presses least.
#include "conventions"
#include "normalDistribution"
#include "tooth"

uniform float tooth;

// The share of the tooth that counts in the middle of an outline; at its sides all of it does.
#define MIDDLE 0.4
// The range of heights of the paper over which an outline goes from full ink to none.
#define OUTLINE_SOFTNESS 0.3

// What is left of full ink. across: 0 in the middle of the outline, 1 at its side.
float dryInk(const in float across) {
  float pressure = 1.0 - tooth * mix(MIDDLE, 1.0, across * across);
  float height = normalDistribution(toothField()).x;
  return clamp((pressure - height) / OUTLINE_SOFTNESS + 1.0, 0.0, 1.0);
}
