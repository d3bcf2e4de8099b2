// The deformation pass draws the corners of a mesh as points. Each vertex is written to its own texel, at the first of its corners:
// position and normal as three.js' chunks deform them, and the rotation by its skin. The other corners are dropped. A mesh with an index is
// drawn by vertices.

#include <common>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include "perTriangle/pulledVertices"
#include "perTriangle/turns"

uniform vec2 targetSize;

flat varying vec3 vPosition;
flat varying vec3 vNormal;
flat varying vec4 vTurn;

void main() {
  gl_PointSize = 1.0;
  #ifdef VERTEX_PER_TEXEL
    int vertex = gl_VertexID;
  #else
    uvec4 own = ownVertices(gl_VertexID / 3);
    int k = gl_VertexID % 3;
    int vertex = int(own[k]);
    if ((own.w & (1u << k)) == 0u) {
      gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
      return;
    }
  #endif // VERTEX_PER_TEXEL

  #include <beginnormal_vertex>
  #include <begin_vertex>
  #include "deformVertex"
  vPosition = transformed;
  vNormal = objectNormal;
  vTurn = vec4(0.0);
  #if defined(USE_SKINNING) && !defined(USE_MORPHTARGETS)
    vTurn = turnOf(mat3(skinMatrix));
  #endif // USE_SKINNING

  vec2 texel = vec2(texelOf(vertex)) + 0.5;
  gl_Position = vec4(2.0 * texel / targetSize - 1.0, 0.0, 1.0);
}
