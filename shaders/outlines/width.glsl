// How wide an outline is at an end of a piece.

// Half the width in pixels where the drawing has its usual weight: before the paper, and before a surface.
vec2 halfWidthsAt(const in PieceEnd end) {
  #ifdef HIDDEN
    return vec2(0.5 * outlineWidth * hiddenWeight(max(end.weight, end.innerWeight)));
  #endif // HIDDEN
  return 0.5 * outlineWidth * vec2(end.weight, end.innerWeight);
}
