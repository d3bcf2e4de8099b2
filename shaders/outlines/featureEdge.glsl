// Borders, creases and edges between materials; and contours along edges whose sides have different normals, so that contours are closed
// curves across creases.
uniform float borders; // weights
uniform float creases;
uniform float materialBorders;
uniform float intersections;
uniform float overshoot; // pixels

// The part of the edge, as t from start to end, where one side faces the eye and the other does not. false if there is none.
bool contourAlong(const in vec2 left, const in vec2 right, out vec2 part) {
  bool startsOn = left.x * right.x < 0.0;
  bool endsOn = left.y * right.y < 0.0;
  // The t at which a side turns away; outside [0, 1] if it never does.
  float leftTurn = left.x * left.y < 0.0 ? left.x / (left.x - left.y) : -1.0;
  float rightTurn = right.x * right.y < 0.0 ? right.x / (right.x - right.y) : -1.0;
  part = vec2(0.0, 1.0);
  if (startsOn && endsOn) return true;
  float turn = max(leftTurn, rightTurn);
  if (startsOn) part.y = turn;
  else if (endsOn) part.x = turn;
  else if (min(leftTurn, rightTurn) >= 0.0) part = vec2(min(leftTurn, rightTurn), turn);
  else return false;
  return part.x < part.y;
}

// The normal of the visible side, towards the eye. Where one side faces the eye and the other does not, the back of the other hides it at a
// concave edge.
vec3 seenNormal(const in OutlinePoint left, const in OutlinePoint right, const in float sign, const in bool isConcave) {
  bool isLeft = left.facing > 0.0;
  bool isRight = sign * right.facing > 0.0;
  if (isLeft == isRight) return (isLeft ? 1.0 : -1.0) * (left.normal + sign * right.normal);
  bool isFront = !(showsBack && isConcave);
  return (isFront ? 1.0 : -1.0) * (isLeft == isFront ? left.normal : sign * right.normal);
}

Piece featureEdge(
  const in uint flags, const in OutlinePoint leftStart, const in OutlinePoint leftEnd,
  const in OutlinePoint rightStart, const in OutlinePoint rightEnd
) {
  // The normals of the right side point inwards where windings are contrary.
  float sign = (flags & EDGE_CONTRARY) != 0u ? -1.0 : 1.0;
  vec2 left = vec2(leftStart.facing, leftEnd.facing);
  vec2 right = sign * vec2(rightStart.facing, rightEnd.facing);

  Piece piece = noPiece();
  piece.isSmooth = false;
  float whole = 0.0;
  if ((flags & EDGE_CREASE) != 0u) whole = creases;
  if ((flags & EDGE_MATERIAL_BORDER) != 0u) whole = max(whole, materialBorders);
  bool isIntersection = (flags & EDGE_INTERSECTION) != 0u;
  if (isIntersection) whole = intersections;
  bool isBorder = (flags & EDGE_BORDER) != 0u;
  bool isBehind = max(max(left.x, left.y), max(right.x, right.y)) <= 0.0;
  #ifndef HIDDEN
    // What lies on a surface is invisible if both sides face away, unless the back shows. Lines where surfaces meet show from behind.
    if (!isIntersection && !showsBack && isBehind) return piece;
  #endif // HIDDEN

  vec2 part;
  bool hasContour = !isBorder && !isIntersection && contourAlong(left, right, part);
  if (isBorder || whole > 0.0) {
    // The whole edge is drawn, as wide as the contour where it is one.
    vec2 isContour = isIntersection ? vec2(0.0) : vec2(lessThan(left * right, vec2(0.0)));
    vec2 ofContour = isBorder ? vec2(borders) : contours * isContour;
    piece.contour = isBorder ? 1.0 : 0.5 * (isContour.x + isContour.y);
    piece.start = endBetween(leftStart, leftEnd, 0.0);
    piece.end = endBetween(leftStart, leftEnd, 1.0);
    weigh(piece.start, ofContour.x, isBorder ? 0.0 : whole);
    weigh(piece.end, ofContour.y, isBorder ? 0.0 : whole);
    if ((flags & EDGE_CORNER_AT_START) != 0u) piece.start.overshoot = overshoot;
    if ((flags & EDGE_CORNER_AT_END) != 0u) piece.end.overshoot = overshoot;
  } else if (hasContour) {
    piece.start = endBetween(leftStart, leftEnd, part.x);
    piece.end = endBetween(leftStart, leftEnd, part.y);
    piece.contour = 1.0;
    weigh(piece.start, contours, 0.0);
    weigh(piece.end, contours, 0.0);
  } else {
    return piece;
  }
  vec3 turn = cross(leftStart.normal, sign * rightStart.normal);
  bool isConcave = dot(turn, leftEnd.position - leftStart.position) < 0.0;
  piece.start.normal = seenNormal(leftStart, rightStart, sign, isConcave);
  piece.end.normal = seenNormal(leftEnd, rightEnd, sign, isConcave);
  // What is a ridge in front is a valley at the back, and the other way round.
  bool isTurned = showsBack && (isBehind || (hasContour && isConcave));
  piece.isValley = !isBorder && isConcave != isTurned;
  return piece;
}
