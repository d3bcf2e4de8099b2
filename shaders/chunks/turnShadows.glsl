// three.js moves the places at which shadow maps are read off the surface, along its normal. On the back of a surface that is drawn from both
// sides they would lie behind it, in its own shadow.
#if defined(USE_SHADOWMAP) && defined(DOUBLE_SIDED)
  vec3 turned = gl_FrontFacing ? vec3(0.0) : 2.0 * (vec4(nonPerturbedNormal, 0.0) * viewMatrix).xyz;
  #include "turnedShadows"
#endif // USE_SHADOWMAP
