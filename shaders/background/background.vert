// The field of lines behind a subject: a triangle that covers the sheet at the far plane.
#include "conventions"

#include <common>
#include <lights_pars_begin>
#include "meanLight"

uniform vec3 centre; // of the subject, view space

varying vec2 vLit; // towards the light on the sheet; of length 1 if it comes from the side

void main() {
  vec3 light = meanLight(centre);
  vLit = dot(light, light) > 0.0 ? normalize(light).xy : vec2(0.0);
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  #ifdef USE_REVERSED_DEPTH_BUFFER
    gl_Position = vec4(corner, 0.0, 1.0);
  #else
    gl_Position = vec4(corner, 1.0, 1.0);
  #endif // USE_REVERSED_DEPTH_BUFFER
}
