// Outlines of pencil, charcoal and chalk: soft at their sides, where the hand presses least, and heavier or lighter as it goes. They
// catch on the tooth of the paper.
#include "normalDistribution"
#include "tooth"

uniform float tooth;

// The tooth from which on the sides fade from the middle on.
#define SOFT_TOOTH 0.3
// How much of the tooth counts against the pressure: a line is pressed harder than what fills a surface.
#define CAUGHT 0.75
// The range of pressures over which an outline goes from none to full ink.
#define OUTLINE_SOFTNESS 0.65
// How much of its pressure an unsteady hand loses along the way.
#define LIFTED 0.5

// What is left of full ink. across: 0 in the middle of the outline, 1 at its side. along: a wave along it, from −1 to 1.
float dryInk(const in float across, const in float along) {
  float side = min(tooth / SOFT_TOOTH, 1.0) * across * across;
  float pressure = (1.0 - side) * (1.0 - tooth * LIFTED * (0.5 - 0.5 * along));
  float height = normalDistribution(toothField()).x;
  return clamp((pressure - CAUGHT * tooth * height) / OUTLINE_SOFTNESS, 0.0, 1.0);
}
