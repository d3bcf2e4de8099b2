#include "technique/debug"

// The printed colour or, in a debug view, a value that it is computed from.
vec3 debugView(const in vec3 printed, const in HatchingParameters h, const in PerToneNormal tone) {
  #if DEBUG_VIEW == DEBUG_VIEW_BLEND_FACTORS
    // Weights of α, β, γ as red, green, blue (paper, figure 8); white where only c counts.
    vec3 f = neighbourWeights(h);
    return 1.0 - vec3(f.y + f.z, f.x + f.z, f.x + f.y) * 0.5;
  #elif DEBUG_VIEW == DEBUG_VIEW_TONE
    return vec3(1.0 - meanTone(h, tone));
  #elif DEBUG_VIEW == DEBUG_VIEW_FRAMES
    // A checkerboard with one square per tile, along the u and v of strokes.
    vec2 square = floor(2.0 * fract(frameUv(h)));
    float odd = abs(square.x - square.y);
    return mix(vec3(0.13, 0.35, 0.55), vec3(0.93, 0.91, 0.84), odd);
  #else
    return printed;
  #endif // DEBUG_VIEW
}
