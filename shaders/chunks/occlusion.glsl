// Baked ambient occlusion: 0 where a surface sees the whole sky, 1 where it sees none of it (src/scene/bakeOcclusion.ts).
varying float vOcclusion;
