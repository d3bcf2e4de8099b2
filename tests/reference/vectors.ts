/** Vector functions on plain arrays, and functions that GLSL has built in. */
import { type mat3, vec3 } from 'gl-matrix';
import type { Vec3 } from './referenceAdjacency.js';

export const dot = (a: Vec3, b: Vec3) => vec3.dot(a, b);
export const cross = (a: Vec3, b: Vec3) => vec3.cross([0, 0, 0], a, b) as Vec3;
export const unit = (a: Vec3) => vec3.normalize([0, 0, 0], a) as Vec3;
export const turned = (a: Vec3, m: mat3) => vec3.transformMat3([0, 0, 0], a, m) as Vec3;
export const mixed = (a: Vec3, s: number, b: Vec3, t: number) => a.map((x, i) => s * x + t * b[i]) as Vec3;
export const clamp01 = (x: number) => Math.min(1, Math.max(0, x));
export const smoothly = (from: number, to: number, x: number) => {
  const t = clamp01((x - from) / (to - from));
  return t * t * (3 - 2 * t);
};
