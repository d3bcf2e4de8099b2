#define FaceNormals vec3
#define PerFaceNormal float

vec3 readFaceNormals(const in float side) {
  // The derivatives' normal, which faces the viewer: the geometry has no attribute for it.
  return safeNormalize(cross(dFdx(vViewPosition), dFdy(vViewPosition)));
}
