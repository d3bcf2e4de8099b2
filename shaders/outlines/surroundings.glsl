// Inputs of three.js' chunks for clipping and fog. Their varyings would not be linear along an outline that runs away from the eye; here
// they are computed per fragment, under the same names.
#if NUM_CLIPPING_PLANES > 0
  uniform vec4 clippingPlanes[NUM_CLIPPING_PLANES];
#endif // NUM_CLIPPING_PLANES

#ifdef USE_FOG
  uniform vec3 fogColor;
  #ifdef FOG_EXP2
    uniform float fogDensity;
  #else
    uniform float fogNear;
    uniform float fogFar;
  #endif // FOG_EXP2
#endif // USE_FOG
