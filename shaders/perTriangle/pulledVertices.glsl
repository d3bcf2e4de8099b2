// The textures of the layout `pull` (src/bake/pullLayout.ts).
uniform highp usampler2D triangleVertices;
uniform highp sampler2D restPositions;

ivec2 texelOf(const in int i, const in int width) {
  return ivec2(i % width, i / width);
}

// V0, V1, V2 and the flags of a triangle.
uvec4 ownVertices(const in int triangle) {
  return texelFetch(triangleVertices, texelOf(2 * triangle, textureSize(triangleVertices, 0).x), 0);
}

// Vα, Vβ, Vγ.
uvec4 oppositeVertices(const in int triangle) {
  return texelFetch(triangleVertices, texelOf(2 * triangle + 1, textureSize(triangleVertices, 0).x), 0);
}

vec4 pullTexel(const in highp sampler2D texels, const in uint vertex) {
  return texelFetch(texels, texelOf(int(vertex), textureSize(texels, 0).x), 0);
}

vec3 pullVertex(const in highp sampler2D texels, const in uint vertex) {
  return pullTexel(texels, vertex).xyz;
}
