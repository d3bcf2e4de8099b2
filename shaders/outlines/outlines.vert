// Contours and feature edges: the vertex shader stage. Three vertices per primitive, a triangle of the mesh or an edge. Each
// primitive holds one piece of outline at most, which becomes one triangle on the screen that covers it with its round ends.
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
#include "emphasis"
#include "outlines/sceneDepth"
#include "outlines/hierarchy"
#ifdef HIDDEN
  #include "outlines/hidden"
#endif // HIDDEN
#include "outlines/width"
#include "outlines/cover"

uniform vec4 eye; // object space; w is 0 for an orthographic camera, and xyz then a direction

void main() {
  // What is not drawn lies outside of the clip volume.
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  clearVaryings();

  uvec4 primitive = readPrimitive(gl_VertexID / 3);
  vec4 seenFrom = eyeOfInstance(eye);
  // Read before the branch: some devices take both ways.
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
  coverPiece(piece, gl_VertexID % 3);
}
