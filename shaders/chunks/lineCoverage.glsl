// How much of a pixel a line covers, all in pixels. away: from its centre. fringe: how far its edge fades beyond its width.
float lineCoverage(const in float away, const in float halfWidth, const in float fringe) {
  // A line thinner than a pixel is drawn as wide as one and as much lighter, so that it fades instead of breaking.
  return clamp(max(halfWidth, 0.5) + fringe - away, 0.0, 1.0) * min(2.0 * halfWidth, 1.0);
}
