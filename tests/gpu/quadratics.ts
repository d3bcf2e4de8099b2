import type { Vec3 } from '../reference/referenceAdjacency.js';

/** Σ aᵢ xᵢ + Σ bᵢ xᵢ², of a place in tiles from the centre. */
export interface Quadratic {
  linear: Vec3;
  squares: Vec3;
}

export const quadraticAt = ({ linear, squares }: Quadratic, place: Vec3): number =>
  place.reduce((sum, x, i) => sum + (linear[i] + squares[i] * x) * x, 0);

export const quadraticGradient = ({ linear, squares }: Quadratic, place: Vec3): Vec3 =>
  place.map((x, i) => linear[i] + 2 * squares[i] * x) as Vec3;
