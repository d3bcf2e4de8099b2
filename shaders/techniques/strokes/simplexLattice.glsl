// The four nearest points of a 3-D simplex lattice of edge 1, with a kernel around each. They are vectors, since an array indexed in a loop
// would live in memory on some devices.
#include "largestComponents"

struct LatticeAnchors {
  mat4x3 offsets; // from each anchor to the point
  vec4 weights;
  uvec4 hashes; // a random word of each anchor
};

// Odd numbers without common patterns.
const uvec3 HASH_STEP = uvec3(0x8da6b343u, 0xd8163841u, 0xcb1ab31fu);

// Random words of the lattice points at cell, cell + second, cell + third and cell + 1, from a sum: products joined by XOR would give
// mirrored cells the same word (finaliser: Wellons, "Prospecting for Hash Functions", 2018). The factor of the lattice is the golden ratio,
// which spreads numbers evenly.
uvec4 hashAnchors(const in ivec3 cell, const in vec3 second, const in vec3 third, const in uint lattice) {
  uvec3 own = uvec3(cell) * HASH_STEP;
  uint toSecond = second.x > 0.5 ? HASH_STEP.x : second.y > 0.5 ? HASH_STEP.y : HASH_STEP.z;
  uint all = HASH_STEP.x + HASH_STEP.y + HASH_STEP.z;
  uint toThird = all - (third.x < 0.5 ? HASH_STEP.x : third.y < 0.5 ? HASH_STEP.y : HASH_STEP.z);
  uvec4 h = own.x + own.y + own.z + lattice * 0x9e3779b9u + uvec4(0u, toSecond, toThird, all);
  h ^= h >> 16u;
  h *= 0x7feb352du;
  h ^= h >> 15u;
  h *= 0x846ca68bu;
  return h ^ (h >> 16u);
}

// lattice: index of the lattice; the words of lattices differ.
LatticeAnchors nearestAnchors(const in vec3 x, const in float lattice) {
  vec3 cell = floor(x + dot(x, vec3(1.0 / 3.0)));
  vec3 first = x - cell + dot(cell, vec3(1.0 / 6.0));
  vec3 second, third;
  largestComponents(first, second, third);
  mat4x3 offsets = mat4x3(first, first - second + 1.0 / 6.0, first - third + 1.0 / 3.0, first - 0.5);
  vec4 squares = vec4(
    dot(offsets[0], offsets[0]), dot(offsets[1], offsets[1]), dot(offsets[2], offsets[2]), dot(offsets[3], offsets[3])
  );
  // The kernel is zero where an anchor enters or leaves the four nearest: at a squared distance of 0.5.
  vec4 weights = max(0.5 - squares, 0.0);
  weights = weights * weights * weights;
  return LatticeAnchors(
    offsets, weights * weights, hashAnchors(ivec3(cell), second, third, uint(int(lattice)))
  );
}
