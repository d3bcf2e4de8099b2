// How wide an outline is at an end of a piece.
uniform float outlineWidth; // pixels

// Half the width in pixels: before the paper, and before a surface. viewPosition: of the end.
vec2 halfWidthsAt(const in PieceEnd end, const in vec3 viewPosition) {
  return 0.5 * outlineWidth * outlineEmphasisAt(viewPosition) * vec2(end.weight, end.innerWeight);
}
