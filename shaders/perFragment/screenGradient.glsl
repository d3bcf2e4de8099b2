// Screen-space derivatives of functions on the object, from the smooth normal: those of dFdx and dFdy would be constant over triangles, and
// show their edges.

// The position of the screen's centre relative to the ray of this fragment, per unit of depth.
vec2 centreOfScreen() {
  return isOrthographic ? vec2(0.0) : vViewPosition.xy / vViewPosition.z;
}

// The Jacobian of the map from pixels to positions on the tangent plane; times a gradient in space it gives that on the screen. normal:
// view space, scaled so that its length is the view units per pixel on the plane. viewToPlace: linear part, for vectors; as a factor on the
// right it takes gradients and normals back.
mat2x3 screenMapOf(const in vec3 normal, const in vec2 centre, const in mat3 viewToPlace) {
  // A line of equal value runs across the gradient and the normal, and is projected as any vector.
  vec3 x = vec3(centre.x * normal.y, -normal.z - centre.x * normal.x, normal.y);
  vec3 y = vec3(normal.z + centre.y * normal.y, -centre.y * normal.x, -normal.x);
  return mat2x3(viewToPlace * x, viewToPlace * y);
}

// The gradient per pixel of a function, from its gradient in space. It is turned by a right angle, and linear.
vec2 screenGradient(const in vec3 gradient, const in mat2x3 onScreen) {
  return gradient * onScreen;
}
