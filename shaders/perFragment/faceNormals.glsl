#define FaceNormals vec3
#define PerFaceNormal float

vec3 readFaceNormals(const in float side) {
  // Nothing is expanded, so no face normal came along; the derivatives' one looks at the viewer by itself.
  return safeNormalize(cross(dFdx(vViewPosition), dFdy(vViewPosition)));
}
