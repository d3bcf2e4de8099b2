// N_t, which tone is computed from: where the four triangles are seen by normals of their own, of c, α, β, γ at once, else
// one that serves them all. Whatever follows is written for either.
#if TECHNIQUE == TECHNIQUE_ADJACENCY && TONE_NORMAL == TONE_NORMAL_FACE
  #define ToneNormals mat4x3
  #define PerToneNormal vec4
#else
  #define ToneNormals vec3
  #define PerToneNormal float
#endif // TECHNIQUE

// View space, turned towards the side that is seen. three has turned smoothNormal.
ToneNormals readToneNormals(const in vec3 smoothNormal, const in float faceDirection) {
  #ifdef DOUBLE_SIDED
    float side = faceDirection;
  #elif defined(FLIP_SIDED)
    float side = -1.0;
  #else
    float side = 1.0;
  #endif // DOUBLE_SIDED
  #if TONE_NORMAL == TONE_NORMAL_SMOOTH
    return smoothNormal;
  #elif TECHNIQUE == TECHNIQUE_ADJACENCY
    return mat4x3(
      safeNormalize(vFaceNormals[0]) * side, safeNormalize(vFaceNormals[1]) * side,
      safeNormalize(vFaceNormals[2]) * side, safeNormalize(vFaceNormals[3]) * side
    );
  #elif TECHNIQUE == TECHNIQUE_ANCHORED
    // Nothing is expanded, so no face normal came along; the derivatives' one looks at the viewer by itself.
    return safeNormalize(cross(dFdx(vViewPosition), dFdy(vViewPosition)));
  #else
    return safeNormalize(vFaceNormal) * side;
  #endif // TONE_NORMAL
}
