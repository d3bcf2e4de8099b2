// The smallest rotation from one direction to another; the identity for null vectors.
mat3 rotationBetween(const in vec3 from, const in vec3 to) {
  vec3 axis = cross(normalize(from), normalize(to));
  float cosine = dot(normalize(from), normalize(to));
  // For opposite directions no axis is better than another.
  if (!(cosine > -0.999)) return mat3(1.0);
  mat3 crossAxis = mat3(0.0, axis.z, -axis.y, -axis.z, 0.0, axis.x, axis.y, -axis.x, 0.0);
  return mat3(1.0) + crossAxis + crossAxis * crossAxis / (1.0 + cosine);
}
