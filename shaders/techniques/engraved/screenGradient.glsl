// How fast a function of the place on the object changes on the screen, from the smooth normal: derivatives of the function
// would be those of flat triangles, and show their edges.

// Surfaces that lean away further than this share of face on are taken for it, which bounds how close lines crowd.
#define LEAST_FACING 0.12

// The tangent plane of a fragment and what the projection makes of it.
struct ScreenMap {
  vec3 e1, e2; // orthonormal, view space
  vec2 j1, j2; // columns of the Jacobian of the projection, pixels per view unit
  float area; // its determinant, held up
};

// n: unit normal, object space.
ScreenMap screenMap(const in vec3 n) {
  // From the left is the transpose: gradients and normals go the other way than vectors do.
  vec3 normal = safeNormalize(n * vViewToObject);
  vec3 q = -vViewPosition;
  // Pixels per view unit, face on.
  float faceOn = pow(abs(determinant(vViewToObject)), 1.0 / 3.0) / vUnitsPerPixel;
  vec3 e1 = safeNormalize(cross(abs(normal.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), normal));
  vec3 e2 = cross(normal, e1);
  vec2 centre = isOrthographic ? vec2(0.0) : q.xy / q.z;
  vec2 j1 = faceOn * (e1.xy - centre * e1.z);
  vec2 j2 = faceOn * (e2.xy - centre * e2.z);
  float area = max(abs(j1.x * j2.y - j1.y * j2.x), LEAST_FACING * faceOn * faceOn);
  return ScreenMap(e1, e2, j1, j2, area);
}

// The length of the screen gradient, object units per pixel, of a function with this gradient in object space.
float screenGradient(const in vec3 gradient, const in ScreenMap s) {
  vec3 g = gradient * vViewToObject;
  vec2 a = vec2(dot(g, s.e1), dot(g, s.e2));
  return length(vec2(s.j2.y * a.x - s.j1.y * a.y, s.j1.x * a.y - s.j2.x * a.x)) / s.area;
}
