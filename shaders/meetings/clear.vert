// A part that is seen through, for the lines where it meets others: the main function of the vertex shader stage of outlines.
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>

uniform float partNumber; // of the part, or of its first instance

varying vec3 vMeetingLight; // towards the light, unit, view space; 0 if no light has a direction
varying float vPartNumber;
varying vec3 vPartPlace; // view space

void main() {
  #include <morphinstance_vertex>
  #include <begin_vertex>
  #include <morphtarget_vertex>
  #include <skinbase_vertex>
  #include <skinning_vertex>
  #include <project_vertex>
  vPartPlace = mvPosition.xyz;
  vPartNumber = partNumber;
  #ifdef USE_INSTANCING
    vPartNumber += float(gl_InstanceID);
  #endif // USE_INSTANCING
  vec3 light = meanLight((modelViewMatrix * vec4(0.0, 0.0, 0.0, 1.0)).xyz);
  vMeetingLight = light / max(length(light), 1e-20);
}
