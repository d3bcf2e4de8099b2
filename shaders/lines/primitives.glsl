// Primitives, all of them or those that are listed (src/bake/lineLayout.ts).
uniform highp usampler2D linePrimitives;
uniform highp usampler2D candidates; // four numbers to a texel
uniform bool isListed;

uvec4 readPrimitive(const in int i) {
  int number = i;
  if (isListed) {
    uvec4 four = texelFetch(candidates, texelOf(i / 4, textureSize(candidates, 0).x), 0);
    number = int(four[i % 4]);
  }
  return texelFetch(linePrimitives, texelOf(number, textureSize(linePrimitives, 0).x), 0);
}

uint flagsOf(const in uvec4 primitive) {
  return (primitive.x >> POINT_BITS) | ((primitive.y >> POINT_BITS) << 4);
}

bool isEdge(const in uvec4 primitive) {
  return (flagsOf(primitive) & EDGE_IS_EDGE) != 0u;
}

// The eye in the space of the instance.
vec4 eyeOfInstance(const in vec4 eye) {
  #ifdef USE_INSTANCING
    return vec4(inverse(mat3(instanceMatrix)) * (eye.xyz - eye.w * instanceMatrix[3].xyz), eye.w);
  #else
    return eye;
  #endif // USE_INSTANCING
}
