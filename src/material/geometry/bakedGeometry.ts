/** What makes a geometry of what was baked. It is fetched while the worker bakes. */
export { applyCorners } from './cornerGeometry.js';
export { applyIndexed } from './indexedGeometry.js';
export { applyPull } from './pulledGeometry.js';
