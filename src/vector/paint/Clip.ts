import type { Vec3 } from '../../look/vectors.js';

/** A clipping plane, which cuts where n·p + d is below 0. World space. */
export type ClipPlane = readonly [x: number, y: number, z: number, d: number];

/** The clipping planes of a surface. */
export interface Clip {
  /** Each of these planes cuts what lies beyond it. */
  each: readonly ClipPlane[];
  /** These planes cut only what lies beyond all of them. */
  together: readonly ClipPlane[];
}

const isBeyond = ([x, y, z, d]: ClipPlane, place: Vec3): boolean => x * place[0] + y * place[1] + z * place[2] + d < 0;

/** Whether a place is clipped. */
export const isClipped = ({ each, together }: Clip, place: Vec3): boolean =>
  each.some((plane) => isBeyond(plane, place)) ||
  (together.length > 0 && together.every((plane) => isBeyond(plane, place)));
