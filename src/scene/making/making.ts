/** What makes geometries and maps, side by side. It is fetched while materials are planned. */
export { bakeGeometries } from './bakeGeometries.js';
export { makeMaps } from './makeMaps.js';
export { progressParts } from './progressParts.js';
export { sideBySide } from './sideBySide.js';
