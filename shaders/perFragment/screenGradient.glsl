// How fast a function of the place on the object changes on the screen, from the smooth normal: derivatives of the function
// would be those of flat triangles, and show their edges.

// The tangent plane of a fragment and what the projection makes of it.
struct ScreenMap {
  mat3 viewToPlace; // linear part, for vectors; its transpose, written as a factor on the right, takes gradients and normals back
  vec3 normal; // view space, of any length
  vec2 centre; // of the screen as seen from here: what one step in depth shifts
  float scale; // view units per pixel of the plane, held down where it leans away, over the length of the normal
};

// n: unit normal, in the space of the places that functions are of.
ScreenMap screenMap(const in vec3 n, const in mat3 viewToPlace) {
  ScreenMap map;
  map.viewToPlace = viewToPlace;
  map.normal = n * viewToPlace;
  map.centre = isOrthographic ? vec2(0.0) : vViewPosition.xy / vViewPosition.z;
  float facing = abs(dot(map.normal, vec3(map.centre, 1.0)));
  map.scale = vViewUnitsPerPixel / max(facing, LEAST_FACING * length(map.normal));
  return map;
}

// The gradient per pixel, on the screen, of a function with this gradient in that space. It is turned by a right angle, and linear.
vec2 screenGradient(const in vec3 gradient, const in ScreenMap map) {
  // Along a line of equal value: as much longer as the function is steeper, and brought to the screen as any vector is.
  vec3 along = cross(map.normal, gradient * map.viewToPlace);
  return map.scale * (along.xy - map.centre * along.z);
}
