// Outlines are heavier away from the light, and thin or lost between lit surface and paper, as illustrators draw them.
#include "meanLight"

uniform vec2 shadeWeights; // on the lit side, on the shaded side
uniform float lostEdges; // share to which contours between lit surface and paper are lost, and the rest thinned

mat4 objectToView() {
  #ifdef USE_INSTANCING
    return modelViewMatrix * instancePlace;
  #else
    return modelViewMatrix;
  #endif // USE_INSTANCING
}

vec3 normalInView(const in vec3 normal) {
  #ifdef USE_INSTANCING
    return normalize(normalMatrix * (normal * inverse(mat3(instancePlace))));
  #else
    return normalize(normalMatrix * normal);
  #endif // USE_INSTANCING
}

// Multiplies the weights of an end by the effect of the light. light: unit, or 0 if no light has a direction. sight: direction to the eye.
// Both vectors are in view space.
void shadeEnd(inout PieceEnd end, const in float contour, const in vec3 light, const in vec3 sight) {
  vec3 normal = normalInView(end.normal);
  float weight = mix(shadeWeights.x, shadeWeights.y, smoothstep(LIT, SHADED, 0.5 - 0.5 * dot(normal, light)));
  end.weight *= weight;
  end.innerWeight *= weight;
  float inside = dot(normalize(normal + INSIDE * sight), light);
  float from = 1.0 - LOST_RANGE * lostEdges;
  float taper = LOST_TAPER.x + LOST_TAPER.y * lostEdges;
  float lost = LOST_WEIGHT.x + LOST_WEIGHT.y * lostEdges;
  end.weight *= 1.0 - contour * lost * smoothstep(from, from + taper, inside);
}

void shade(inout Piece piece) {
  vec3 middle = (objectToView() * vec4(0.5 * (piece.start.position + piece.end.position), 1.0)).xyz;
  vec3 light = meanLight(middle);
  light /= max(length(light), 1e-20);
  vec3 sight = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-middle);
  shadeEnd(piece.start, piece.contour, light, sight);
  shadeEnd(piece.end, piece.contour, light, sight);
}
