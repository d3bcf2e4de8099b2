// A piece of outline on the surface.
struct PieceEnd {
  vec3 position; // object space
  vec3 anchor; // the same at rest
  vec3 normal; // not of unit length
  float weight; // of the outline's width
  float bend; // see OutlinePoint
  float overshoot; // pixels by which the outline runs on
};

struct Piece {
  PieceEnd start, end;
  float extent; // how deep the triangle of the piece is along the line of sight, object units
  bool isSmooth; // on a surface, not an edge
};

PieceEnd noEnd() {
  return PieceEnd(vec3(0.0), vec3(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.0, 0.0);
}

Piece noPiece() {
  return Piece(noEnd(), noEnd(), 0.0, true);
}

bool isPiece(const in Piece piece) {
  return max(piece.start.weight, piece.end.weight) > 0.0;
}

// The end that lies at t ∈ [0, 1] from a to b.
PieceEnd endBetween(const in OutlinePoint a, const in OutlinePoint b, const in float t) {
  return PieceEnd(
    mix(a.position, b.position, t), mix(a.anchor, b.anchor, t), mix(a.normal, b.normal, t), 0.0, mix(a.bend, b.bend, t), 0.0
  );
}

float extentAlong(const in OutlinePoint a, const in OutlinePoint b, const in OutlinePoint c, const in vec4 eye) {
  vec3 v = normalize(towardsEye(a.position, eye));
  vec3 depths = vec3(0.0, dot(b.position - a.position, v), dot(c.position - a.position, v));
  return max(max(depths.x, depths.y), depths.z) - min(min(depths.x, depths.y), depths.z);
}
