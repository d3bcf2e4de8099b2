// A piece of outline on the surface.
struct PieceEnd {
  vec3 position; // object space
  vec3 anchor; // the same at rest
  vec3 normal; // not of unit length
  float weight; // of the outline's width, before the paper
  float innerWeight; // before a surface
  float bend; // see OutlinePoint
  float overshoot; // pixels by which the outline runs on
};

struct Piece {
  PieceEnd start, end;
  float extent; // how deep the surface beside the piece is along the line of sight, object units
  float ownCover; // how much of that may lie before the piece, though the piece is to be seen, object units
  float contour; // the share of the piece that is a contour or a border
  bool isSmooth; // on a surface, not an edge
  bool isValley; // an edge whose two sides rise from it
};

PieceEnd noEnd() {
  return PieceEnd(vec3(0.0), vec3(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.0, 0.0, 0.0);
}

Piece noPiece() {
  return Piece(noEnd(), noEnd(), 0.0, 0.0, 0.0, true, false);
}

bool isPiece(const in Piece piece) {
  return max(max(piece.start.weight, piece.end.weight), max(piece.start.innerWeight, piece.end.innerWeight)) > 0.0;
}

// The end that lies at t ∈ [0, 1] from a to b.
PieceEnd endBetween(const in OutlinePoint a, const in OutlinePoint b, const in float t) {
  return PieceEnd(
    mix(a.position, b.position, t), mix(a.anchor, b.anchor, t), mix(a.normal, b.normal, t), 0.0, 0.0, mix(a.bend, b.bend, t), 0.0
  );
}

uniform float innerContours; // the weight of contours and borders before a surface, as a share of that before the paper

// Sets the weights of an end. ofContour: as a contour or a border. whole: as anything else.
void weigh(inout PieceEnd end, const in float ofContour, const in float whole) {
  end.weight = max(ofContour, whole);
  end.innerWeight = max(innerContours * ofContour, whole);
}

// Sets how deep the triangle of a piece is along the line of sight: across the piece, not along it, where a long triangle may run
// away from the eye over all of its length.
void measureExtent(inout Piece piece, const in OutlinePoint a, const in OutlinePoint b, const in OutlinePoint c, const in vec4 eye) {
  vec3 v = normalize(towardsEye(a.position, eye));
  vec3 along = piece.end.position - piece.start.position;
  along /= max(length(along), 1e-20);
  vec3 ab = b.position - a.position;
  vec3 ac = c.position - a.position;
  vec3 across = v - dot(v, along) * along;
  vec3 depths = vec3(0.0, dot(ab, across), dot(ac, across));
  piece.extent = max(max(depths.x, depths.y), depths.z) - min(min(depths.x, depths.y), depths.z);
  // A triangle that looks away is hidden by its neighbours, though the smooth surface has its contour there.
  vec3 n = cross(ab, ac);
  piece.ownCover = dot(n, v) * dot(n, a.normal + b.normal + c.normal) > 0.0 ? 0.0 : piece.extent;
}
