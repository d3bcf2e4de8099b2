// All primitives, or those in a list (src/mesh/bake/outlineLayout.ts).
uniform highp usampler2D outlinePrimitives;
uniform highp usampler2D candidates; // four per texel; with instances two, each with the index of its instance
uniform bool isListed;
#ifdef USE_INSTANCING
  uniform highp sampler2D instancePlaces; // one column per texel
  mat4 instancePlace; // matrix of the primitive's instance
#endif // USE_INSTANCING

uvec4 readPrimitive(const in int i) {
  int number = i;
  #ifdef USE_INSTANCING
    instancePlace = instanceMatrix;
    if (isListed) {
      uvec4 two = texelFetch(candidates, texelOf(i / 2, textureSize(candidates, 0).x), 0);
      number = int(two[2 * (i % 2)]);
      int column = 4 * int(two[2 * (i % 2) + 1]);
      int width = textureSize(instancePlaces, 0).x;
      for (int k = 0; k < 4; k++) instancePlace[k] = texelFetch(instancePlaces, texelOf(column + k, width), 0);
    }
  #else
    if (isListed) {
      uvec4 four = texelFetch(candidates, texelOf(i / 4, textureSize(candidates, 0).x), 0);
      number = int(four[i % 4]);
    }
  #endif // USE_INSTANCING
  return texelFetch(outlinePrimitives, texelOf(number, textureSize(outlinePrimitives, 0).x), 0);
}

// The number in the highest bits of two words.
uint highBits(const in uvec2 words) {
  return (words.x >> POINT_BITS) | ((words.y >> POINT_BITS) << 4);
}

uint flagsOf(const in uvec4 primitive) {
  return highBits(primitive.xy);
}

bool isEdge(const in uvec4 primitive) {
  return (flagsOf(primitive) & EDGE_IS_EDGE) != 0u;
}

// The distance of the lines there, object units.
float spacingOf(const in uvec4 primitive) {
  return radius * exp2(float(highBits(primitive.zw)) / -SPACING_STEPS);
}

// Whether the instance is hidden by a scale of 0.
bool isScaledToNothing() {
  #ifdef USE_INSTANCING
    vec3 size = vec3(dot(instancePlace[0], instancePlace[0]), dot(instancePlace[1], instancePlace[1]), dot(instancePlace[2], instancePlace[2]));
    return size.x + size.y + size.z == 0.0;
  #else
    return false;
  #endif // USE_INSTANCING
}

// The eye in the space of the instance.
vec4 eyeOfInstance(const in vec4 eye) {
  #ifdef USE_INSTANCING
    return vec4(inverse(mat3(instancePlace)) * (eye.xyz - eye.w * instancePlace[3].xyz), eye.w);
  #else
    return eye;
  #endif // USE_INSTANCING
}
