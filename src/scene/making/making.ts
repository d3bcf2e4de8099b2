/** What makes materials, geometries and maps. Whoever hatches a scene fetches it first, and pages need nothing of it before. */
export { displaceMeshes } from '../displaceMeshes.js';
export { geometryPlans } from '../geometryPlans.js';
export { MaterialReplacer } from '../MaterialReplacer.js';
export { planMeshes } from '../planMeshes.js';
export { bakeGeometries } from './bakeGeometries.js';
export { makeMaps } from './makeMaps.js';
export { progressParts } from './progressParts.js';
export { sideBySide } from './sideBySide.js';
