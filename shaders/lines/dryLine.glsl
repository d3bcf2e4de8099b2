// Lines of pencil, charcoal and chalk: they catch on the tooth of the paper, most at their sides, where the hand presses least.
#include "conventions"
#include "normalDistribution"
#include "tooth"

uniform float tooth;

// How much of the tooth counts in the middle of a line.
#define MIDDLE 0.4
// Over so much of the heights of the paper a line goes from all to nothing.
#define LINE_SOFTNESS 0.3

// What is left of full ink. across: 0 in the middle of the line, 1 at its side.
float dryInk(const in float across) {
  float pressure = 1.0 - tooth * mix(MIDDLE, 1.0, across * across);
  float height = normalDistribution(toothField()).x;
  return clamp((pressure - height) / LINE_SOFTNESS + 1.0, 0.0, 1.0);
}
