// The end points of outlines (src/mesh/bake/outlineLayout.ts).
uniform highp usampler2D outlinePoints;
uniform float radius; // of the bounding sphere, object units
#ifdef DEFORMED
  // Written by the deformation pass, by vertex.
  uniform highp sampler2D deformedPositions;
  uniform highp sampler2D deformedNormals;
  uniform highp sampler2D deformedTurns;
#endif // DEFORMED

struct OutlinePoint {
  vec3 position; // object space
  vec3 anchor; // object space, at rest
  vec3 normal; // unit
  float facing; // n·v: above 0 where the surface faces the eye
  float bend; // curvature along the line of sight, times the bounding radius
};

ivec2 texelOf(const in int i, const in int width) {
  return ivec2(i % width, i / width);
}

vec3 octahedralNormal(const in uint word) {
  vec2 folded = unpackSnorm2x16(word);
  vec3 n = vec3(folded, 1.0 - abs(folded.x) - abs(folded.y));
  float below = max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -below : below;
  n.y += n.y >= 0.0 ? -below : below;
  return normalize(n);
}

vec3 towardsEye(const in vec3 position, const in vec4 eye) {
  return eye.xyz - eye.w * position;
}

OutlinePoint readPoint(const in uint word, const in vec4 eye) {
  ivec2 texel = texelOf(2 * int(word & POINT_MASK), textureSize(outlinePoints, 0).x);
  uvec4 place = texelFetch(outlinePoints, texel, 0);
  uvec4 shape = texelFetch(outlinePoints, texel + ivec2(1, 0), 0);
  OutlinePoint p;
  p.anchor = uintBitsToFloat(place.xyz);
  p.position = p.anchor;
  p.normal = octahedralNormal(place.w);
  mat3 toRest = mat3(1.0);
  #ifdef DEFORMED
    ivec2 vertex = texelOf(int(shape.w), textureSize(deformedPositions, 0).x);
    p.position = texelFetch(deformedPositions, vertex, 0).xyz;
    vec4 turn = texelFetch(deformedTurns, vertex, 0);
    if (turn == vec4(0.0)) {
      // Morph targets change the normal only.
      vec3 n = texelFetch(deformedNormals, vertex, 0).xyz;
      if (dot(n, n) > 0.0) p.normal = normalize(n);
    } else {
      toRest = turnBack(turn);
      p.normal = p.normal * toRest; // from the left, that is by the transpose of the inverse rotation: the rotation itself
    }
  #endif // DEFORMED
  vec3 v = towardsEye(p.position, eye);
  p.facing = dot(p.normal, v);
  vec3 w = toRest * (v - p.facing * p.normal);
  vec2 kx = unpackHalf2x16(shape.x); // xx xy
  vec2 ky = unpackHalf2x16(shape.y); // xz yy
  vec2 kz = unpackHalf2x16(shape.z); // yz zz
  vec3 kw = vec3(
    dot(vec3(kx, ky.x), w), dot(vec3(kx.y, ky.y, kz.x), w), dot(vec3(ky.x, kz.x, kz.y), w)
  );
  float length2 = dot(w, w);
  p.bend = length2 > 0.0 ? dot(w, kw) / length2 : 0.0;
  return p;
}
