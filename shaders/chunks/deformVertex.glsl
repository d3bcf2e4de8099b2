// Deforms the vertex with three.js' chunks.
#include <morphnormal_vertex>
vec3 morphedNormal = objectNormal;
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
