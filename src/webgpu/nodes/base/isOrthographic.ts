import { tsl, type Value } from './values.js';

/** Whether the camera is orthographic: the last row of its projection ends in 1, in WebXR too. */
export const isOrthographic = (): Value => tsl.cameraProjectionMatrix.element(3).element(3).equal(1);
