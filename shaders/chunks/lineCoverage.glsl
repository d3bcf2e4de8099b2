// The share of a pixel that a line covers. away: distance from its centre. fringe: how far its edge fades beyond its width. All in pixels.
float lineCoverage(const in float away, const in float halfWidth, const in float fringe) {
  // A line thinner than a pixel is drawn one pixel wide and paler, so that it does not break up.
  return clamp(max(halfWidth, 0.5) + fringe - away, 0.0, 1.0) * min(2.0 * halfWidth, 1.0);
}
