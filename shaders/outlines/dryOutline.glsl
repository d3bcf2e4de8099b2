// Outlines of pencil, charcoal and chalk. They are soft at their sides, vary in pressure along the way, and catch on the tooth of the
// paper.
#include "normalDistribution"
#include "tooth"

uniform float paperGrain;

// The tooth above which the sides fade from the middle on.
#define SOFT_TOOTH 0.3
// The effect of tooth on outlines, which are pressed harder than hatching.
#define CAUGHT 0.75
// The range of pressures over which an outline goes from none to full ink.
#define OUTLINE_SOFTNESS 0.65
// The share of pressure that an unsteady hand loses along the way.
#define LIFTED 0.5

// The share of full ink that is left. across: 0 in the middle of the outline, 1 at its side. along: a wave along it, from −1 to 1.
float dryInk(const in float across, const in float along) {
  float side = min(paperGrain / SOFT_TOOTH, 1.0) * across * across;
  float pressure = (1.0 - side) * (1.0 - paperGrain * LIFTED * (0.5 - 0.5 * along));
  float height = normalDistribution(toothField()).x;
  return clamp((pressure - CAUGHT * paperGrain * height) / OUTLINE_SOFTNESS, 0.0, 1.0);
}
