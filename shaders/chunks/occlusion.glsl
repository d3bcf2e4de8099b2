// Baked ambient occlusion: 0 where a surface sees the whole sky, 1 where it sees none of it (src/scene/bakeOcclusion.ts). Where both sides
// are drawn, that of the front and of the back.
#ifdef DOUBLE_SIDED
  varying vec2 vOcclusion;
#else
  varying float vOcclusion;
#endif // DOUBLE_SIDED
