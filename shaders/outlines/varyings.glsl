// The same at all three vertices: what the fragments need to know of the piece of outline they may lie on. Not `flat`, which some
// devices pay for.
varying vec4 vEnds; // start and end on the screen, pixels
varying vec2 vHalfWidths; // at the start and the end, pixels
varying vec4 vStart; // view space, and the distance that its depth has, nearer than it lies
varying vec4 vEnd;
#ifdef WOBBLE
  varying vec3 vAnchorStart; // object space, at rest
  varying vec3 vAnchorEnd;
#endif // WOBBLE
