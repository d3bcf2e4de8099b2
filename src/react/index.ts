/**
 * Components and hooks for React Three Fiber.
 *
 * @module three-hatching/react
 */
export { Hatched } from './Hatched.js';
export type { HatchedGroupProps, HatchedOptions, HatchedProps } from './HatchedProps.js';
export { HatchingOutlines, type HatchingOutlinesProps } from './HatchingOutlines.js';
export type { MapAddress, SharedMapOptions, SharedMapSource } from './sharedMaps.js';
export { type HatchingGeometryOptions, useHatchingGeometry } from './useHatchingGeometry.js';
export { useTonalArtMap } from './useTonalArtMap.js';

import './elements.js';
