// The level of the threshold map at a fragment. crowding: octaves by which its strokes are finer than drawn.
ThresholdLevel crispLevel(const in vec2 uv, out float crowding) {
  float level = levelFor(minification(uv, thresholdMapSize));
  crowding = crowdingOf(uv, thresholdMapSize, level);
  return chooseLevel(level);
}
