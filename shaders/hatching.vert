// Light-oriented hatching after Suarez, Belhadj and Boyer, "GPU real time hatching", 2013: the geometry shader stage.
#include "conventions"
#include "strokeLayers"
#include "hatchingVaryings"

varying vec3 vViewPosition;

uniform float viewportHeight; // pixels

#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>

#include "triangleGeometry"
#if TECHNIQUE == TECHNIQUE_ANCHORED
  #include "anchorAttributes"
  #include "deformedToRest"
#else
  #include <lights_pars_begin>
  #include "lightOrientation"
  #include "adjacencyPrimitive"
  #include "hatchingParameters"
#endif // TECHNIQUE

void main() {
  #include <uv_vertex>
  #include <color_vertex>
  #include <morphinstance_vertex>
  #include <morphcolor_vertex>
  #include <batching_vertex>

  #include <beginnormal_vertex>
  #include <begin_vertex>
  #include "deformVertex"
  #include <defaultnormal_vertex>
  #include <normal_vertex>
  #include <project_vertex>
  #include <logdepthbuf_vertex>
  #include <clipping_planes_vertex>

  vViewPosition = -mvPosition.xyz;

  #include <worldpos_vertex>
  #include <shadowmap_vertex>
  #include <fog_vertex>

  #include "emitHatchingParameters"
}
