// An end of a piece of outline.
struct PieceEnd {
  vec3 position; // object space
  vec3 anchor; // object space, at rest
  vec3 normal; // not of unit length
  float weight; // weight of the outline before paper
  float innerWeight; // weight before a surface
  float bend; // see OutlinePoint
  float overshoot; // length by which the outline overshoots the end, pixels
};

struct Piece {
  PieceEnd start, end;
  float extent; // depth of the surface beside the piece along the line of sight, object units
  float ownCover; // part of that depth that may lie before a visible piece, object units
  float contour; // share of the piece that is a contour or a border
  bool isSmooth; // whether it lies on a surface, not on an edge
  bool isValley; // whether it is a concave edge
  float side; // 1 if it is seen from the front of the surface, -1 from the back
};

PieceEnd noEnd() {
  return PieceEnd(vec3(0.0), vec3(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.0, 0.0, 0.0);
}

Piece noPiece() {
  return Piece(noEnd(), noEnd(), 0.0, 0.0, 0.0, true, false, 1.0);
}

bool isPiece(const in Piece piece) {
  return max(max(piece.start.weight, piece.end.weight), max(piece.start.innerWeight, piece.end.innerWeight)) > 0.0;
}

// The end at t ∈ [0, 1] from a to b.
PieceEnd endBetween(const in OutlinePoint a, const in OutlinePoint b, const in float t) {
  return PieceEnd(
    mix(a.position, b.position, t), mix(a.anchor, b.anchor, t), mix(a.normal, b.normal, t), 0.0, 0.0, mix(a.bend, b.bend, t), 0.0
  );
}

uniform bool showsBack; // whether the back of the surface can be seen

// Makes a piece one that is seen from the back of the surface.
void turnToBack(inout Piece piece) {
  piece.side = -1.0;
  piece.start.normal *= -1.0;
  piece.end.normal *= -1.0;
  piece.start.bend *= -1.0;
  piece.end.bend *= -1.0;
}

uniform float innerContours; // weight of contours and borders before a surface, as a share of that before paper

// Sets the weights of an end. ofContour: as a contour or a border. whole: as anything else.
void weigh(inout PieceEnd end, const in float ofContour, const in float whole) {
  end.weight = max(ofContour, whole);
  end.innerWeight = max(innerContours * ofContour, whole);
}

// Sets the depth of a piece's triangle along the line of sight. It is measured across the piece: along it, a long triangle may run away
// from the eye.
void measureExtent(inout Piece piece, const in OutlinePoint a, const in OutlinePoint b, const in OutlinePoint c, const in vec4 eye) {
  vec3 v = normalize(towardsEye(a.position, eye));
  vec3 along = piece.end.position - piece.start.position;
  along /= max(length(along), 1e-20);
  vec3 ab = b.position - a.position;
  vec3 ac = c.position - a.position;
  vec3 across = v - dot(v, along) * along;
  vec3 depths = vec3(0.0, dot(ab, across), dot(ac, across));
  piece.extent = max(max(depths.x, depths.y), depths.z) - min(min(depths.x, depths.y), depths.z);
  // A triangle that faces away is hidden by its neighbours, even where the smooth surface has its contour on it.
  vec3 n = cross(ab, ac);
  piece.ownCover = dot(n, v) * dot(n, piece.side * (a.normal + b.normal + c.normal)) > 0.0 ? 0.0 : piece.extent;
}
