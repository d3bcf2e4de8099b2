// A tent filter. A sample of a comparison sampler is the bilinear mean of four comparisons, so samples no more than a texel apart give an
// edge without steps.

int samplesAside(const in float radius) {
  return int(clamp(ceil(radius), 0.0, MOST_SAMPLES));
}

float tentWeight(const in int x, const in int y, const in int n) {
  float span = float(n + 1);
  return (span - abs(float(x))) * (span - abs(float(y))) / (span * span * span * span);
}
