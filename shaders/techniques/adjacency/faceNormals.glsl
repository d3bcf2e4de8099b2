// Of c, α, β, γ at once.
#define FaceNormals mat4x3
#define PerFaceNormal vec4

mat4x3 readFaceNormals(const in float side) {
  return mat4x3(
    safeNormalize(vFaceNormals[0]) * side, safeNormalize(vFaceNormals[1]) * side,
    safeNormalize(vFaceNormals[2]) * side, safeNormalize(vFaceNormals[3]) * side
  );
}
