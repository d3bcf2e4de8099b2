// Suggestive contours: where a contour would appear if the eye moved a little (DeCarlo, Finkelstein, Rusinkiewicz and Santella, "Suggestive
// contours for conveying shape", 2003). They are the zero set of the curvature along the line of sight, where it grows towards the eye, on
// triangles that face the eye, or whose back does.
uniform float suggestiveContours; // weight

Piece suggestiveContour(const in OutlinePoint a, const in OutlinePoint b, const in OutlinePoint c, const in vec4 eye) {
  Piece piece = noPiece();
  bool isBehind = showsBack && max(max(a.facing, b.facing), c.facing) < 0.0;
  if (min(min(a.facing, b.facing), c.facing) <= 0.0 && !isBehind) return piece;
  if (!zeroSet(a, b, c, vec3(a.bend, b.bend, c.bend), piece.start, piece.end)) return piece;
  if (isBehind) turnToBack(piece);

  // The gradient of the curvature, which is linear over the triangle.
  vec3 ab = b.position - a.position;
  vec3 ac = c.position - a.position;
  vec3 n = cross(ab, ac);
  vec3 gradient = cross(n, (c.bend - a.bend) * ab - (b.bend - a.bend) * ac) / max(dot(n, n), 1e-30);
  vec3 normal = normalize(a.normal + b.normal + c.normal);
  vec3 v = normalize(towardsEye((a.position + b.position + c.position) / 3.0, eye));
  vec3 w = v - dot(normal, v) * normal;
  float lean = length(w);
  float growth = piece.side * radius * dot(gradient, w) / max(lean, 1e-6);
  float weight = suggestiveContours * smoothstep(LEAST_GROWTH, FULL_GROWTH, growth * smoothstep(LEAST_LEAN, FULL_LEAN, lean));
  weigh(piece.start, 0.0, weight);
  weigh(piece.end, 0.0, weight);
  return piece;
}
