// The textures of the layout `pull` (src/mesh/bake/pullLayout.ts).
uniform highp usampler2D triangleVertices;
uniform highp sampler2D restPositions;
uniform int pullRowShift; // texels in a row of these textures, as a power of two

ivec2 texelOf(const in int i) {
  return ivec2(i & ((1 << pullRowShift) - 1), i >> pullRowShift);
}

// V0, V1, V2 and the flags of a triangle.
uvec4 ownVertices(const in int triangle) {
  return texelFetch(triangleVertices, texelOf(2 * triangle), 0);
}

// Vα, Vβ, Vγ.
uvec4 oppositeVertices(const in int triangle) {
  return texelFetch(triangleVertices, texelOf(2 * triangle + 1), 0);
}

vec4 pullTexel(const in highp sampler2D texels, const in uint vertex) {
  return texelFetch(texels, texelOf(int(vertex)), 0);
}

vec3 pullVertex(const in highp sampler2D texels, const in uint vertex) {
  return pullTexel(texels, vertex).xyz;
}
