// Rotations as quaternions (x, y, z, w).

// The rotation of a linear map; zero for one that mirrors or flattens.
vec4 turnOf(const in mat3 m) {
  if (!(determinant(m) > 0.0)) return vec4(0.0);
  vec3 x = normalize(m[0]);
  vec3 y = normalize(m[1] - x * dot(x, m[1]));
  vec3 z = cross(x, y);
  // Four times the square of each component, minus 1; dividing by the largest component is the most accurate.
  vec4 squares = vec4(x.x - y.y - z.z, y.y - z.z - x.x, z.z - x.x - y.y, x.x + y.y + z.z);
  float largest = max(max(squares.x, squares.y), max(squares.z, squares.w));
  vec4 turn =
    squares.w == largest ? vec4(y.z - z.y, z.x - x.z, x.y - y.x, 1.0 + largest)
    : squares.x == largest ? vec4(1.0 + largest, x.y + y.x, z.x + x.z, y.z - z.y)
    : squares.y == largest ? vec4(x.y + y.x, 1.0 + largest, y.z + z.y, z.x - x.z)
    : vec4(z.x + x.z, y.z + z.y, 1.0 + largest, x.y - y.x);
  return normalize(turn);
}

// The mean of three rotations, not of unit length; zero if one of them is.
vec4 addTurns(const in vec4 a, const in vec4 b, const in vec4 c) {
  if (a == vec4(0.0) || b == vec4(0.0) || c == vec4(0.0)) return vec4(0.0);
  // A quaternion and its negative are the same rotation.
  return a + (dot(a, b) < 0.0 ? -b : b) + (dot(a, c) < 0.0 ? -c : c);
}

// The matrix of the inverse rotation.
mat3 turnBack(const in vec4 turn) {
  vec4 q = normalize(turn);
  vec3 v = q.xyz;
  mat3 crossMatrix = mat3(0.0, v.z, -v.y, -v.z, 0.0, v.x, v.y, -v.x, 0.0);
  return mat3(1.0) - 2.0 * q.w * crossMatrix + 2.0 * crossMatrix * crossMatrix;
}
