import type { Matrix4 } from 'three';

/** Whether a matrix maps everything to one point, which hides an object or an instance. */
export const isScaledToNothing = ({ elements: m }: Matrix4): boolean =>
  m[0] === 0 &&
  m[1] === 0 &&
  m[2] === 0 &&
  m[4] === 0 &&
  m[5] === 0 &&
  m[6] === 0 &&
  m[8] === 0 &&
  m[9] === 0 &&
  m[10] === 0;
