// Light-oriented hatching after Suarez, Belhadj and Boyer, "GPU real time hatching", 2013: the geometry shader stage. Includes of
// "technique/…" come from the folder of the material's technique.
#include "conventions"
#include "smoothNormal"
#include "strokeLayers"
#include "technique/varyings"

varying vec3 vViewPosition;
#include "occlusion"
#include "plainColor"

#include <common>
#include <batching_pars_vertex>
#include "mapCoordinates"
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>

#ifdef PLAIN_COLOR
  uniform vec3 diffuse;
  uniform vec3 emissive;
  uniform float emissiveIntensity;
  #include "lightness"
  #include "localDarkness"
#endif // PLAIN_COLOR
#include "hatchNormal"
#include "unitsPerPixel"
#include "technique/vertex"

void main() {
  #include "emitMapCoordinates"
  #include <color_vertex>
  #include <morphinstance_vertex>
  #include <morphcolor_vertex>
  #include <batching_vertex>

  #include <beginnormal_vertex>
  #include <begin_vertex>
  #include "technique/deform"
  #include <defaultnormal_vertex>
  #include <normal_vertex>
  #include <project_vertex>
  #include <logdepthbuf_vertex>
  #include <clipping_planes_vertex>

  vViewPosition = -mvPosition.xyz;

  #include "emitOcclusion"
  #ifdef PLAIN_COLOR
    vDarkness = localDarkness(diffuse, emissiveIntensity * emissive);
  #endif // PLAIN_COLOR

  #include <worldpos_vertex>
  #include <shadowmap_vertex>
  #include <fog_vertex>

  {
    #include "objectToView"
    #include "technique/emit"
  }
}
