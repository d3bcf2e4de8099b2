// Illustrators draw the side away from the light with a heavier outline, and a thin one between lit surface and paper.
#include "meanLight"

uniform vec2 shadeWeights; // lit, shaded
uniform float lostEdges; // how much of the contours between lit surface and paper is lost, and how thin the rest becomes

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

// Shades an end. light: of unit length, or 0 where no light has a direction. sight: the direction to the eye. Both in view space.
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
