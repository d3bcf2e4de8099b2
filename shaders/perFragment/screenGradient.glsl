// How fast a function of the place on the object changes on the screen, from the smooth normal: derivatives of the function
// would be those of flat triangles, and show their edges.

// The centre of the screen as seen from here: what one step in depth shifts.
vec2 centreOfScreen() {
  return isOrthographic ? vec2(0.0) : vViewPosition.xy / vViewPosition.z;
}

// What the projection makes of the tangent plane of a fragment: a matrix that takes the gradient of a function to the one on the screen.
// normal: view space, of the length at which it stands for as many view units as a pixel of the plane has. viewToPlace: linear part, for
// vectors; its transpose, written as a factor on the right, takes gradients and normals back.
mat2x3 screenMapOf(const in vec3 normal, const in vec2 centre, const in mat3 viewToPlace) {
  // Along a line of equal value: across its gradient and the normal, and brought to the screen as any vector is.
  vec3 x = vec3(centre.x * normal.y, -normal.z - centre.x * normal.x, normal.y);
  vec3 y = vec3(normal.z + centre.y * normal.y, -centre.y * normal.x, -normal.x);
  return mat2x3(viewToPlace * x, viewToPlace * y);
}

// normal: view space, of any length. Where the plane leans away it is held back.
mat2x3 screenMapInView(const in vec3 normal, const in mat3 viewToPlace) {
  vec2 centre = centreOfScreen();
  float facing = abs(dot(normal, vec3(centre, 1.0)));
  return screenMapOf(normal * (vViewUnitsPerPixel / max(facing, LEAST_FACING * length(normal))), centre, viewToPlace);
}

// n: unit normal, in the space of the places that functions are of.
mat2x3 screenMap(const in vec3 n, const in mat3 viewToPlace) {
  return screenMapInView(n * viewToPlace, viewToPlace);
}

// The same of the flat triangle that the fragment lies on.
mat2x3 triangleOnScreen(const in mat3 viewToPlace) {
  return screenMapInView(cross(dFdx(vViewPosition), dFdy(vViewPosition)), viewToPlace);
}

// The gradient per pixel, on the screen, of a function with this gradient in that space. It is turned by a right angle, and linear.
vec2 screenGradient(const in vec3 gradient, const in mat2x3 onScreen) {
  return gradient * onScreen;
}
