// The same at all three vertices: what the fragments need to know of the piece of outline they may lie on. Not `flat`, which some
// devices pay for.
varying vec4 vEnds; // start and end on the screen, pixels
varying vec4 vHalfWidths; // of start and end before the paper, of both before a surface, pixels
varying vec4 vStart; // view space, and the distance that its depth has, nearer than it lies
varying vec4 vEnd;
varying vec2 vOvershoots; // by how much the outline runs on beyond start and end, pixels
varying vec4 vStandings; // how start and end stand before what lies behind them (hierarchy.glsl); negative where fragments find out
varying float vContour; // the share of an outline that is a contour or a border, and not only a crease
varying float vTolerance; // how far the surface may lie before its own outline, view units
#ifdef HIDDEN
  varying vec2 vOrigin; // of the object on the screen, pixels
#endif // HIDDEN
#ifdef WOBBLE
  varying vec3 vAnchorStart; // object space, at rest
  varying vec3 vAnchorEnd;
#endif // WOBBLE
