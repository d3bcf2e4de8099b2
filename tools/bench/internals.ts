/** Internals of the library that the benchmarks use: the steps of the bake and of the maps. */

export { buildTriangleAdjacency, consistentTwins } from '../../src/mesh/adjacency/buildTriangleAdjacency.js';
export { joinBorders } from '../../src/mesh/adjacency/joinBorders.js';
export { pairEdges } from '../../src/mesh/adjacency/pairEdges.js';
export { bakeCorners, expandPerCorner, packCornerAttributes, packCorners } from '../../src/mesh/bake/bakeCorners.js';
export { bakeIndexed } from '../../src/mesh/bake/bakeIndexed.js';
export { bakePull, packPull } from '../../src/mesh/bake/bakePull.js';
export { DEFAULT_SMOOTHING_SHARE, nearnessOf, type Surface } from '../../src/mesh/bake/bakeSurface.js';
export { packHatchNormals } from '../../src/mesh/bake/packAttributes.js';
export { splitVertices } from '../../src/mesh/bake/splitVertices.js';
export { computeAreaNormals } from '../../src/mesh/computeAreaNormals.js';
export { combedField } from '../../src/mesh/form/bakeForm.js';
export { cutForm } from '../../src/mesh/form/cutForm.js';
export { directionField } from '../../src/mesh/form/directions/directionField.js';
export { faceDirections } from '../../src/mesh/form/directions/faceDirections.js';
export { FORM_DEFAULTS } from '../../src/mesh/form/FormField.js';
export { formSurface } from '../../src/mesh/form/FormSurface.js';
export { measureBounds } from '../../src/mesh/measureBounds.js';
export { cutCreases, cutSharpEdges } from '../../src/mesh/normals/cutCreases.js';
export { type FanNormals, fanDirections } from '../../src/mesh/normals/fanNormals.js';
export { buildFans } from '../../src/mesh/normals/fans.js';
export { absorbSmallPatches, findPatches } from '../../src/mesh/normals/findPatches.js';
export { smoothFanNormals } from '../../src/mesh/normals/smoothFanNormals.js';
export { type TriangleMesh, validateTriangleMesh } from '../../src/mesh/TriangleMesh.js';
export { weldPositions } from '../../src/mesh/weldPositions.js';
export { generateHatchImages, type MapRequest } from '../../src/strokes/tamImages/generateHatchImages.js';
export { generateThresholds } from '../../src/strokes/tamImages/generateThresholds.js';
