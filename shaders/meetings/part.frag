// The map of parts: what part is seen in each pixel, and the plane in which it lies there.
#include <clipping_planes_pars_fragment>

uniform float partLook; // number of the material of its outlines, from 1

varying float vPartNumber;
varying vec3 vPartPlace;

layout(location = 0) out highp uvec4 partWord;

void main() {
  #include <clipping_planes_fragment>
  // Larger where it is nearer, and linear over the screen on a plane.
  float nearness = isOrthographic ? vPartPlace.z : -1.0 / vPartPlace.z;
  uint number = uint(vPartNumber + 0.5) % 0xffffu + 1u;
  uint slopeX = floatBitsToUint(dFdx(nearness));
  uint slopeY = floatBitsToUint(dFdy(nearness));
  partWord = uvec4(uint(partLook + 0.5) << 16 | number, floatBitsToUint(nearness), slopeX, slopeY);
}
