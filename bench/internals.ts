/** What the benchmarks know of the library beyond its public names: the bake and the maps, step by step. */

export { joinBorders } from '../src/adjacency/joinBorders.js';
export { pairEdges } from '../src/adjacency/pairEdges.js';
export { bake } from '../src/bake/bake.js';
export { bakeIndexed } from '../src/bake/bakeIndexed.js';
export { bakePull } from '../src/bake/bakePull.js';
export { DEFAULT_SMOOTHING_SHARE, nearnessOf, type Surface } from '../src/bake/bakeSurface.js';
export { expandPerCorner } from '../src/bake/expandPerCorner.js';
export { packCornerAttributes } from '../src/bake/packCornerAttributes.js';
export { packCorners } from '../src/bake/packCorners.js';
export { packHatchNormals } from '../src/bake/packHatchNormals.js';
export { packPull } from '../src/bake/packPull.js';
export { splitVertices } from '../src/bake/splitVertices.js';
export { generateHatchImages } from '../src/hatchImages/generateHatchImages.js';
export { generateThresholds } from '../src/hatchImages/generateThresholds.js';
export type { HatchImageOptions } from '../src/hatchImages/hatchImageOptions.js';
export { computeAreaNormals } from '../src/mesh/computeAreaNormals.js';
export { measureBounds } from '../src/mesh/measureBounds.js';
export type { TriangleMesh } from '../src/mesh/TriangleMesh.js';
export { validateTriangleMesh } from '../src/mesh/validateTriangleMesh.js';
export { weldPositions } from '../src/mesh/weldPositions.js';
export { absorbSmallPatches } from '../src/normals/absorbSmallPatches.js';
export { buildFans } from '../src/normals/buildFans.js';
export { cutCreases } from '../src/normals/cutCreases.js';
export { cutSharpEdges } from '../src/normals/cutSharpEdges.js';
export type { FanNormals } from '../src/normals/FanNormals.js';
export { fanDirections } from '../src/normals/fanDirections.js';
export { smoothFanNormals } from '../src/normals/smoothFanNormals.js';
