// Hidden outlines. Each end is moved along its ray towards the eye before the depth test, so far that the surface it lies on does
// not hide it, and hardly further; it stays where it is on the screen. What lies before it by less is found by the fragments
// (hierarchy.glsl).

uniform float pull; // how many slopes to a pixel nearer than it lies the surface is drawn (polygonOffsetFactor)

// halfWidth: of the outline, in view units. pixel: likewise. scale: view units per object unit. Returns view units.
float liftOf(const in PieceEnd end, const in Piece piece, const in float halfWidth, const in float pixel, const in float scale) {
  float r = radius * scale;
  float own = LIFT_SHARE * r + piece.extent * scale + 4.0 * EDGE_SLOPE * pull * pixel;
  if (!piece.isSmooth) return own + 2.0 * EDGE_SLOPE * halfWidth;
  // A surface of curvature κ rises by √(2x/κ) towards the eye over the distance x beside its contour. Without this, half of
  // the outline drowns.
  float rise = sqrt(2.0 * halfWidth * r / max(end.bend, 1e-3));
  return own + 2.0 * halfWidth + min(rise, MOST_RISE * r);
}

// How far the surface may lie before its own outline. pixel: in view units.
float toleranceOf(const in Piece piece, const in float pixel, const in float scale) {
  return (ROUNDING * radius + piece.ownCover) * scale + (pull + (piece.isValley ? LOOKED_BESIDE : 0.0)) * EDGE_SLOPE * pixel;
}

vec3 lifted(const in vec3 position, const in float lift) {
  if (isOrthographic) return position + vec3(0.0, 0.0, lift);
  return position * (1.0 - min(lift / max(length(position), 1e-20), 0.9));
}
