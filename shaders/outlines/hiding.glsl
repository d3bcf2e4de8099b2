// Before the depth test each end is moved towards the eye along its ray, just far enough that its own surface does not hide it. It keeps
// its place on the screen. Occluders within that distance are found per fragment (hierarchy.glsl).

uniform float pull; // polygonOffsetFactor of the surface, negated: slopes per pixel by which it is drawn nearer than it lies

// The distance, in view units, by which an end is moved towards the eye. halfWidth: of the outline, view units. pixel: likewise. scale:
// view units per object unit.
float liftOf(const in PieceEnd end, const in Piece piece, const in float halfWidth, const in float pixel, const in float scale) {
  float r = radius * scale;
  float own = LIFT_SHARE * r + piece.extent * scale + 4.0 * EDGE_SLOPE * pull * pixel;
  if (!piece.isSmooth) return own + 2.0 * EDGE_SLOPE * halfWidth;
  // A surface of curvature κ rises by √(2x/κ) towards the eye over the distance x beside its contour. Without this, half of the outline
  // would be hidden.
  float rise = sqrt(2.0 * halfWidth * r / max(end.bend, 1e-3));
  return own + 2.0 * halfWidth + min(rise, MOST_RISE * r);
}

// Distance by which a surface may lie before its own outline. pixel: in view units.
float toleranceOf(const in Piece piece, const in float pixel, const in float scale) {
  return (ROUNDING * radius + piece.ownCover) * scale + (pull + (piece.isValley ? LOOKED_BESIDE : 0.0)) * EDGE_SLOPE * pixel;
}

vec3 lifted(const in vec3 position, const in float lift) {
  if (isOrthographic) return position + vec3(0.0, 0.0, lift);
  return position * (1.0 - min(lift / max(length(position), 1e-20), 0.9));
}
