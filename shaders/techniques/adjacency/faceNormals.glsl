// The normals of c, α, β, γ at once.
#define FaceNormals mat4x3
#define PerFaceNormal vec4

#if TONE_NORMAL == TONE_NORMAL_FACE
  mat4x3 readFaceNormals(const in float side) {
    return mat4x3(
      vFaceNormalCentral * side, vFaceNormalAlpha.xyz * side, vFaceNormalBeta.xyz * side, vFaceNormalGamma.xyz * side
    );
  }
#endif // TONE_NORMAL

// Overloads for four normals at once.
float lightness(const in float y);

vec4 lightness(const in vec4 y) {
  return vec4(lightness(y.x), lightness(y.y), lightness(y.z), lightness(y.w));
}

vec4 cosines(const in vec3 direction, const in mat4x3 normals) {
  return direction * normals;
}

float indirectRadiance(const in vec3 n);

vec4 indirectRadiance(const in mat4x3 normals) {
  return vec4(
    indirectRadiance(normals[0]), indirectRadiance(normals[1]), indirectRadiance(normals[2]), indirectRadiance(normals[3])
  );
}
