// The contour of a smooth surface: the zero set of n·v, linear over a triangle (Hertzmann and Zorin, "Illustrating smooth
// surfaces", 2000).
uniform float contours; // weight
uniform float taper; // curvature times the bounding radius above which the outline has its full width

// The taper of a contour: it is visible where the surface bends away from the eye, and ends in a cusp where that curvature is 0
// (Koenderink).
float taperAt(const in float bend) {
  return taper > 0.0 ? smoothstep(0.0, taper, bend) : step(0.0, bend);
}

// The two points on the edges of a triangle at which `values` is 0; false if it has one sign.
bool zeroSet(
  const in OutlinePoint a, const in OutlinePoint b, const in OutlinePoint c, const in vec3 values, inout PieceEnd start, inout PieceEnd end
) {
  bvec3 positive = greaterThanEqual(values, vec3(0.0));
  if (all(positive) || !any(positive)) return false;
  // The edges from the corner with the lone sign to the other two are cut.
  if (positive.y == positive.z) {
    start = endBetween(a, b, values.x / (values.x - values.y));
    end = endBetween(a, c, values.x / (values.x - values.z));
  } else if (positive.x == positive.z) {
    start = endBetween(b, c, values.y / (values.y - values.z));
    end = endBetween(b, a, values.y / (values.y - values.x));
  } else {
    start = endBetween(c, a, values.z / (values.z - values.x));
    end = endBetween(c, b, values.z / (values.z - values.y));
  }
  return true;
}

Piece contour(const in OutlinePoint a, const in OutlinePoint b, const in OutlinePoint c) {
  Piece piece = noPiece();
  if (zeroSet(a, b, c, vec3(a.facing, b.facing, c.facing), piece.start, piece.end)) {
    // The back has its contours where the front bends towards the eye.
    if (showsBack && piece.start.bend + piece.end.bend < 0.0) turnToBack(piece);
    weigh(piece.start, contours * taperAt(piece.start.bend), 0.0);
    weigh(piece.end, contours * taperAt(piece.end.bend), 0.0);
    piece.contour = 1.0;
  }
  return piece;
}
