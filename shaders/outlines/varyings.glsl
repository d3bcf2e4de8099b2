// The piece of outline that a fragment may lie on, constant over its triangle. Not `flat`, which is slow on some devices.
varying vec4 vEnds; // start and end on the screen, pixels
varying vec4 vHalfWidths; // half widths of start and end before paper, and of both before a surface, pixels
varying vec4 vStart; // view space, and the distance of its depth, which is nearer
varying vec4 vEnd;
varying vec2 vOvershoots; // lengths of the overshoots at start and end, pixels
varying vec4 vLineWeights; // line weights at start and end (hierarchy.glsl); negative where they are computed per fragment
varying float vContour; // share of an outline that is a contour or a border, not a crease
varying float vTolerance; // distance by which a surface may lie before its own outline, view units
#ifdef HIDDEN
  varying vec2 vOrigin; // screen position of the object's origin, pixels
#endif // HIDDEN
#ifdef WOBBLE
  varying vec3 vAnchorStart; // object space, at rest
  varying vec3 vAnchorEnd;
#endif // WOBBLE
