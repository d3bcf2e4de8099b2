// The four nearest points of a 3-D simplex lattice of edge 1, and a kernel around each. All four at once, as vectors: an
// array that a loop walks through would live in memory on some devices.

struct LatticeAnchors {
  mat4x3 offsets; // from each anchor to the point
  vec4 weights;
  uvec4 hashes; // a random word each
};

// Random words for the lattice points at cell, cell + second, cell + third and cell + 1 (finaliser: Wellons, "Prospecting
// for Hash Functions", 2018).
uvec4 hashAnchors(const in ivec3 cell, const in uvec3 second, const in uvec3 third, const in uint lattice) {
  uvec3 base = uvec3(cell);
  uvec4 h = (base.x + uvec4(0u, second.x, third.x, 1u)) * 0x8da6b343u;
  h ^= (base.y + uvec4(0u, second.y, third.y, 1u)) * 0xd8163841u;
  h ^= (base.z + uvec4(0u, second.z, third.z, 1u)) * 0xcb1ab31fu;
  h ^= lattice * 0x9e3779b9u;
  h ^= h >> 16u;
  h *= 0x7feb352du;
  h ^= h >> 15u;
  h *= 0x846ca68bu;
  return h ^ (h >> 16u);
}

// lattice: anchors of different lattices get different words.
LatticeAnchors nearestAnchors(const in vec3 x, const in float lattice) {
  vec3 cell = floor(x + dot(x, vec3(1.0 / 3.0)));
  vec3 first = x - cell + dot(cell, vec3(1.0 / 6.0));
  // Ties go the same way in all components, or the lattice would tear along its diagonals.
  vec3 greater = step(first.yzx, first.xyz);
  vec3 less = 1.0 - greater;
  vec3 second = min(greater, less.zxy);
  vec3 third = max(greater, less.zxy);
  mat4x3 offsets = mat4x3(first, first - second + 1.0 / 6.0, first - third + 1.0 / 3.0, first - 0.5);
  vec4 squares = vec4(
    dot(offsets[0], offsets[0]), dot(offsets[1], offsets[1]), dot(offsets[2], offsets[2]), dot(offsets[3], offsets[3])
  );
  // Zero where an anchor comes into or drops out of the four nearest: 0.5 is the squared distance at which it does.
  vec4 weights = max(0.5 - squares, 0.0);
  weights = weights * weights * weights;
  return LatticeAnchors(
    offsets, weights * weights, hashAnchors(ivec3(cell), uvec3(second), uvec3(third), uint(int(lattice)))
  );
}
