// The width of an outline at an end of a piece.

// Half widths before paper and before a surface, pixels, without the factor of fading.
vec2 halfWidthsAt(const in PieceEnd end) {
  #ifdef HIDDEN
    return vec2(0.5 * outlineWidth * hiddenWeight(max(end.weight, end.innerWeight)));
  #endif // HIDDEN
  return 0.5 * outlineWidth * vec2(end.weight, end.innerWeight);
}
