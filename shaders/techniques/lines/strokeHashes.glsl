// Random numbers of strokes.
// Random bits of a line, from which the hashes of its strokes are made.
uint bitsOfLine(const in float line) {
  uint spread = floatBitsToUint(line);
  spread = (spread ^ spread >> 12u) * GOLDEN_RATIO;
  return (spread ^ spread >> 13u) * THIRD_FACTOR;
}

// A hash of a stroke in [0, 1), far from those of its neighbours on the line.
float strokeHash01(const in uint bits, const in float stroke) {
  return float(bits + uint(int(stroke)) * THUE_MORSE >> 8u) / 16777216.0;
}
