// Unit normal of a triangle, counter-clockwise outward (Algorithm 1, line 1); zero for a triangle without area.
vec3 triangleNormal(const in vec3 a, const in vec3 b, const in vec3 c) {
  vec3 ab = b - a;
  vec3 ac = c - a;
  // Scaled, since for tiny or huge triangles the squared length of the product would underflow or overflow.
  float scale = 1.0 / max(max(max3(abs(ab)), max3(abs(ac))), 1e-37);
  vec3 n = cross(scale * ab, scale * ac);
  return n * inversesqrt(max(dot(n, n), 1e-36));
}

struct Triangle {
  vec3 a, b, c;
};

vec3 normalOf(const in Triangle t) {
  return triangleNormal(t.a, t.b, t.c);
}

// The linear map from one triangle to another, and from the unit normal of the one to that of the other.
mat3 triangleToTriangle(const in Triangle from, const in Triangle to) {
  vec3 n = normalOf(from);
  vec3 ab = from.b - from.a;
  vec3 ac = from.c - from.a;
  float doubleArea = dot(n, cross(ab, ac));
  if (!(doubleArea > 0.0)) return mat3(1.0);
  // The dual basis of ab, ac and n: the components of a vector are its products with these.
  mat3 dual = mat3(cross(ac, n) / doubleArea, cross(n, ab) / doubleArea, n);
  return mat3(to.b - to.a, to.c - to.a, normalOf(to)) * transpose(dual);
}
