// Of c, α, β, γ at once.
#define FaceNormals mat4x3
#define PerFaceNormal vec4

#if TONE_NORMAL == TONE_NORMAL_FACE
  mat4x3 readFaceNormals(const in float side) {
    return mat4x3(
      vFaceNormalCentral * side, vFaceNormalAlpha.xyz * side, vFaceNormalBeta.xyz * side, vFaceNormalGamma.xyz * side
    );
  }
#endif // TONE_NORMAL
