import type { Matrix3 } from 'three';
import type { Mat3 } from '../shading/screenGradient.js';

/** The rows of a matrix of three.js. */
export function rowsOf({ elements: e }: Matrix3): Mat3 {
  return [
    [e[0], e[3], e[6]],
    [e[1], e[4], e[7]],
    [e[2], e[5], e[8]],
  ];
}
