// What goes into the hatch, made visible.
vec3 debugColor(const in HatchingParameters h, const in PerToneNormal tone) {
  #if DEBUG_VIEW == DEBUG_VIEW_BLEND_FACTORS
    // Contribution of α, β, γ as red, green, blue (paper, figure 8); white where only c counts.
    return 1.0 - vec3(h.weights.z + h.weights.w, h.weights.y + h.weights.w, h.weights.y + h.weights.z) * 0.5;
  #elif DEBUG_VIEW == DEBUG_VIEW_TONE
    return vec3(1.0 - dot(vec4(tone), h.weights) / dot(h.weights, vec4(1.0)));
  #else
    // A checker of one square per tile in the frame of c: its lines are the strokes' u and v.
    #if TECHNIQUE == TECHNIQUE_ANCHORED
      vec2 uv = strokeScale * vec2(dot(h.point, h.uAxis), dot(h.point, h.vAxis));
    #else
      vec2 uv = h.uv[0];
    #endif // TECHNIQUE
    vec2 square = floor(2.0 * fract(uv));
    float odd = abs(square.x - square.y);
    return mix(vec3(0.13, 0.35, 0.55), vec3(0.93, 0.91, 0.84), odd);
  #endif // DEBUG_VIEW
}
