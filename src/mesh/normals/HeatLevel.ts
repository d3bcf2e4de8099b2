import type { HeatEquation } from './assembleHeatEquation.js';

/** The heat equation on a surface, or on a coarser copy of it. */
export interface HeatLevel {
  heat: HeatEquation;
  /** Where each node lies, three coordinates each. Undefined where heat spreads over few nodes only: a coarser copy is not needed then. */
  places: Float32Array | undefined;
  /** For each node the share of the radius over which heat spreads there, at most 1. Undefined stands for 1 everywhere. */
  shares: Float32Array | undefined;
}
