// The parts of a scene, each with a number of its own: the vertex shader stage.
#include <common>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>

uniform float partNumber; // of the part, or of its first instance

varying float vPartNumber;
varying vec3 vPartPlace; // view space

void main() {
  #include <morphinstance_vertex>
  #include <begin_vertex>
  #include <morphtarget_vertex>
  #include <skinbase_vertex>
  #include <skinning_vertex>
  #include <project_vertex>
  #include <clipping_planes_vertex>
  vPartPlace = mvPosition.xyz;
  vPartNumber = partNumber;
  #ifdef USE_INSTANCING
    vPartNumber += float(gl_InstanceID);
  #endif // USE_INSTANCING
}
