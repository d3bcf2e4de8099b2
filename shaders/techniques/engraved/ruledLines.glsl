// One family of lines: level sets of a function at equal distances, whose width is the tone. As one comes nearer a new line is
// born between every two (the octaves of a ruler), and the share of ink stays the tone throughout.
uniform float lineSpacing; // pixels between lines, or 256ths of a tile

// Below so many pixels between lines they fade into their tone, so that none shimmer.
#define FINEST_SPACING 2.0

// The ink of one line. away: of the fragment from its centre, halfWidth: of the line, both in pixels.
float lineInk(const in float away, const in float halfWidth) {
  // Below a pixel the line keeps its ink and loses its darkness.
  return clamp(max(halfWidth, 0.5) + 0.5 - away, 0.0, 1.0) * min(2.0 * halfWidth, 1.0);
}

// value: of the function. perPixel: its change from one pixel to the next. Returns the darkness.
float ruledLines(const in float value, const in float perPixel, const in float tone) {
  float onObject = log2(lineSpacing / (256.0 * strokeScale));
  float onScreen = log2(lineSpacing * perPixel);
  float octave = -mix(onObject, onScreen, screenConstancy);
  float whole = floor(octave);
  float born = smoothstep(0.0, 1.0, octave - whole);
  float period = exp2(-whole);
  float x = value / period;
  float pixels = period / perPixel;
  float below = floor(x);
  float oldWidth = 0.5 * tone * (1.0 - 0.5 * born) * pixels;
  float youngWidth = 0.25 * tone * born * pixels;
  // All that a pixel may lie on: their shares of it add up.
  float ink = min(1.0,
    lineInk((x - below) * pixels, oldWidth * handWidth(below * period))
    + lineInk(abs(x - below - 0.5) * pixels, youngWidth * handWidth((below + 0.5) * period))
    + lineInk((below + 1.0 - x) * pixels, oldWidth * handWidth((below + 1.0) * period))
  );
  float spacing = mix(pixels, 0.5 * pixels, born);
  return mix(tone, ink, smoothstep(FINEST_SPACING, 1.6 * FINEST_SPACING, spacing));
}
