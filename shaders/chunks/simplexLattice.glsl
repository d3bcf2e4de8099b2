// The four nearest points of a 3-D simplex lattice of edge 1, and a kernel around each.

struct LatticeAnchors {
  vec3 offset[4]; // from the anchor to the point
  ivec3 id[4];
};

// Ties go the same way in all components, or the lattice would tear along its diagonals.
LatticeAnchors nearestAnchors(const in vec3 x) {
  vec3 cell = floor(x + dot(x, vec3(1.0 / 3.0)));
  vec3 first = x - cell + dot(cell, vec3(1.0 / 6.0));
  vec3 greater = step(first.yzx, first.xyz);
  vec3 less = 1.0 - greater;
  vec3 second = min(greater, less.zxy);
  vec3 third = max(greater, less.zxy);
  ivec3 base = ivec3(cell);
  LatticeAnchors anchors;
  anchors.offset[0] = first;
  anchors.offset[1] = first - second + 1.0 / 6.0;
  anchors.offset[2] = first - third + 1.0 / 3.0;
  anchors.offset[3] = first - 0.5;
  anchors.id[0] = base;
  anchors.id[1] = base + ivec3(second);
  anchors.id[2] = base + ivec3(third);
  anchors.id[3] = base + 1;
  return anchors;
}

// Zero where an anchor comes into or drops out of the four nearest: 0.5 is the squared distance at which it does.
float anchorWeight(const in vec3 offset) {
  float w = max(0.5 - dot(offset, offset), 0.0);
  w = w * w * w;
  return w * w;
}

// A random word for a lattice point (finaliser: Wellons, "Prospecting for Hash Functions", 2018).
uint hashAnchor(const in ivec3 id, const in uint lattice) {
  uvec3 words = uvec3(id) * uvec3(0x8da6b343u, 0xd8163841u, 0xcb1ab31fu);
  uint h = words.x ^ words.y ^ words.z ^ (lattice * 0x9e3779b9u);
  h ^= h >> 16u;
  h *= 0x7feb352du;
  h ^= h >> 15u;
  h *= 0x846ca68bu;
  return h ^ (h >> 16u);
}
