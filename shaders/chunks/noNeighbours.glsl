// For debugViews, where nothing is blended with neighbours.
vec3 neighbourWeights(const in HatchingParameters h) {
  return vec3(0.0);
}

float meanTone(const in HatchingParameters h, const in float tone) {
  return tone;
}
