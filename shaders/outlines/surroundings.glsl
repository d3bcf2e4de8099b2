// What three's chunks for clipping, and fog look for. Theirs hand it over in varyings, which would bend along
// an outline that runs away from the eye; here it is worked out for each fragment, under the same names.
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
