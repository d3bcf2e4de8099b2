// What three's chunks for clipping, fog and logarithmic depth look for. Theirs hand it over in varyings, which would bend along
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

// As three calls it since 0.180 or so, and as it did before.
#if defined(USE_LOGARITHMIC_DEPTH_BUFFER) || defined(USE_LOGDEPTHBUF)
  #define LOGARITHMIC_DEPTH
  uniform float logDepthBufFC;
#endif // USE_LOGARITHMIC_DEPTH_BUFFER
