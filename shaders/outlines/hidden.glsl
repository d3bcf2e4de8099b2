// Outlines behind a surface, thin and dashed or faint, as in technical drawings.
uniform bool isDashed;

float hiddenWeight(const in float weight) {
  return HIDDEN_WEIGHT * smoothstep(0.0, WHOLE_FROM, weight);
}

// The share of a pixel that is drawn, by dashes and gaps. place: along a piece that is `size` long. fromOrigin: from the screen position of
// the object, so that dashes move with it. All in pixels.
float hiddenCoverage(const in float place, const in float size, const in vec2 along, const in vec2 fromOrigin, const in float width) {
  if (!isDashed) return FAINT;
  float gap = GAP * width;
  float period = (DASH + GAP) * width;
  float x;
  if (size > 2.0 * period) {
    // An edge begins and ends with a dash.
    period = (size + gap) / floor((size + gap) / period + 0.5);
    x = clamp(place, 0.0, size);
  } else {
    // The pieces of a curve are shorter than dashes, so their pattern follows the screen.
    x = abs(along.x) > abs(along.y) ? fromOrigin.x : fromOrigin.y;
  }
  float dash = period - gap;
  return clamp(0.5 * dash - abs(mod(x, period) - 0.5 * dash) + 0.5, 0.0, 1.0);
}
