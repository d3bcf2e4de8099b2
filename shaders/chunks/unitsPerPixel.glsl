uniform float viewportHeight; // pixels

// Object units per pixel at a vertex.
float unitsPerPixel(const in mat3 viewToObject, const in vec4 viewPosition) {
  float away = isOrthographic ? 1.0 : -viewPosition.z;
  // The cube root of the determinant: the mean scale over directions.
  float scale = pow(abs(determinant(viewToObject)), 1.0 / 3.0);
  return away * scale * 2.0 / (abs(projectionMatrix[1][1]) * viewportHeight);
}
