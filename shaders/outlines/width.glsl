// How wide an outline is at an end of a piece.

// Half the width in pixels where the drawing has its usual weight: before the paper, and before a surface.
vec2 halfWidthsAt(const in PieceEnd end) {
  return 0.5 * outlineWidth * vec2(end.weight, end.innerWeight);
}
