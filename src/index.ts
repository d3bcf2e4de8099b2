export type { PrepareHatchingGeometryOptions } from './geometry/prepareHatchingGeometry.js';
export { prepareHatchingGeometry } from './geometry/prepareHatchingGeometry.js';
export type { HatchingMaterialOptions, HatchingMaterialParameters } from './material/HatchingMaterial.js';
export { HatchingMaterial } from './material/HatchingMaterial.js';
export type { DebugView, HatchingTechnique, ToneModel, ToneNormal } from './material/shaderConventions.js';
