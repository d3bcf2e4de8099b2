// Contours and feature edges: the vertex shader stage. There are three vertices per primitive, which is a triangle of the mesh or an edge.
// Each primitive has at most one piece of outline, which becomes one screen triangle that covers it with its round ends.
#include "conventions"
#include "outlines/conventions"
#include "outlines/varyings"

#include <common>
#include <lights_pars_begin>

#include "perTriangle/turns"
#include "outlines/points"
#include "outlines/primitives"
#include "outlines/piece"
#include "outlines/contour"
#include "outlines/suggestiveContour"
#include "outlines/featureEdge"
#include "outlines/shade"
#include "outlines/hiding"
#include "fading"
#include "outlines/sceneDepth"
#include "outlines/hierarchy"
#ifdef HIDDEN
  #include "outlines/hidden"
#endif // HIDDEN
#include "outlines/cover"

uniform vec4 eye; // object space; for an orthographic camera w is 0 and xyz the direction to the eye

void main() {
  // Pieces that are not drawn lie outside of clip space.
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);

  uvec4 primitive = readPrimitive(gl_VertexID / 3);
  vec4 seenFrom = eyeOfInstance(eye);
  // Read before the branch, since some devices run both sides of it.
  OutlinePoint a = readPoint(primitive.x, seenFrom);
  OutlinePoint b = readPoint(primitive.y, seenFrom);
  OutlinePoint c = readPoint(primitive.z, seenFrom);
  OutlinePoint d = readPoint(primitive.w, seenFrom);
  Piece piece;
  if (isEdge(primitive)) {
    piece = featureEdge(flagsOf(primitive), a, b, c, d);
  } else {
    piece = contour(a, b, c);
    if (suggestiveContours > 0.0 && !isPiece(piece)) piece = suggestiveContour(a, b, c, seenFrom);
    measureExtent(piece, a, b, c, seenFrom);
  }
  if (!isPiece(piece) || isScaledToNothing()) return;

  #ifndef HIDDEN
    shade(piece);
  #endif // HIDDEN
  coverPiece(piece, spacingOf(primitive), gl_VertexID % 3);
}
