// Texture coordinates by channel, one varying for all maps of a channel; three.js has one varying per map.
#if defined(USE_UV) || defined(USE_UV0)
  varying vec2 vUv;
#endif // USE_UV
#ifdef USE_UV1
  varying vec2 vUv1;
#endif // USE_UV1
#ifdef USE_UV2
  varying vec2 vUv2;
#endif // USE_UV2
#ifdef USE_UV3
  varying vec2 vUv3;
#endif // USE_UV3
