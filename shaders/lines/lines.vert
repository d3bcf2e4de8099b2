// Contours and feature edges: the vertex shader stage. Three vertices per primitive, a triangle of the mesh or an edge. Each
// primitive holds one piece of line at most, which becomes one triangle on the screen that covers it with its round ends.
#include "conventions"
#include "lines/conventions"
#include "lines/varyings"

#include <common>
#include <lights_pars_begin>

#include "perTriangle/turns"
#include "lines/points"
#include "lines/primitives"
#include "lines/piece"
#include "lines/contour"
#include "lines/suggestiveContour"
#include "lines/featureEdge"
#include "lines/shade"
#include "lines/hiding"
#include "lines/cover"

uniform vec4 eye; // object space; w is 0 for an orthographic camera, and xyz then a direction

void main() {
  // What is not drawn lies outside of the clip volume.
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  clearVaryings();

  uvec4 primitive = readPrimitive(gl_VertexID / 3);
  vec4 seenFrom = eyeOfInstance(eye);
  // Read before the branch: some devices take both ways.
  LinePoint a = readPoint(primitive.x, seenFrom);
  LinePoint b = readPoint(primitive.y, seenFrom);
  LinePoint c = readPoint(primitive.z, seenFrom);
  LinePoint d = readPoint(primitive.w, seenFrom);
  Piece piece;
  if (isEdge(primitive)) {
    piece = featureEdge(flagsOf(primitive), a, b, c, d);
  } else {
    piece = contour(a, b, c);
    if (suggestiveContours > 0.0 && !isPiece(piece)) piece = suggestiveContour(a, b, c, seenFrom);
    piece.extent = extentAlong(a, b, c, seenFrom);
  }
  if (!isPiece(piece)) return;

  shade(piece);
  coverPiece(piece, gl_VertexID % 3);
}
