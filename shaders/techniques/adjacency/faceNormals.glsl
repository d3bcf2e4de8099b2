// Of c, α, β, γ at once.
#define FaceNormals mat4x3
#define PerFaceNormal vec4

#if TONE_NORMAL == TONE_NORMAL_FACE
  mat4x3 readFaceNormals(const in float side) {
    return mat4x3(
      safeNormalize(vFaceNormalCentral) * side, safeNormalize(vFaceNormalAlpha.xyz) * side,
      safeNormalize(vFaceNormalBeta.xyz) * side, safeNormalize(vFaceNormalGamma.xyz) * side
    );
  }
#endif // TONE_NORMAL
