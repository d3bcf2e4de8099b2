// Ink and paper as one colour with an alpha, not premultiplied.
uniform vec3 ink;
uniform vec3 paper;
uniform float paperOpacity;

// ground: paper, tinted by the surface colour. darkness: of the hatch.
vec4 printedColor(const in vec3 ground, const in float darkness) {
  #if INK_BLEND == INK_BLEND_MULTIPLY
    vec3 stroke = ground * ink;
  #else
    vec3 stroke = ink;
  #endif // INK_BLEND
  #if defined(OPAQUE) && !defined(USE_ALPHATEST) && !defined(USE_ALPHAHASH)
    // Opaque drawings let nothing show through.
    return vec4(mix(ground, stroke, darkness), 1.0);
  #else
    float alpha = 1.0 - (1.0 - paperOpacity) * (1.0 - darkness);
    return vec4(mix(paperOpacity * ground, stroke, darkness) / max(alpha, 1e-6), alpha);
  #endif // OPAQUE
}
