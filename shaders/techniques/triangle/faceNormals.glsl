#define FaceNormals vec3
#define PerFaceNormal float

vec3 readFaceNormals(const in float side) {
  return vFaceNormal * side;
}
