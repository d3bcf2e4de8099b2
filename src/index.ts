export type { HatchingStatistics } from './geometry/HatchingStatistics.js';
export type { PrepareHatchingGeometryOptions } from './geometry/prepareHatchingGeometry.js';
export { prepareHatchingGeometry } from './geometry/prepareHatchingGeometry.js';
export type { HatchingMaterialOptions, HatchingMaterialParameters } from './material/HatchingMaterial.js';
export { HatchingMaterial } from './material/HatchingMaterial.js';
export type { DebugView, HatchingTechnique, ToneModel, ToneNormal } from './material/shaderConventions.js';
export { TonalArtMap } from './tam/TonalArtMap.js';
export type { TaskOptions } from './worker/TaskOptions.js';
