/**
 * Components and hooks for React Three Fiber.
 *
 * @module three-hatching/react
 */

export type { HatchedGroupProps, HatchedProps } from './Hatched.js';
export { Hatched } from './Hatched.js';
export { HatchingOutlines, type HatchingOutlinesProps } from './HatchingOutlines.js';
export type { HatchedOptions } from './hatchedOptions.js';
export { type HatchingGeometryOptions, useHatchingGeometry, useTonalArtMap } from './hooks.js';
export type { MapAddress, SharedMapOptions, SharedMapSource } from './sharedMaps.js';

import './elements.js';
