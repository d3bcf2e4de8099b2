import type { Camera } from 'three';
import type { ViewedCamera } from '../pictureOffset.js';
import type { SeenDepths } from './seenDepths.js';

/** The ratio of a scene's depth to the width of its sheet at which it begins to fade automatically. */
const DEEP_FROM = 3;
/** The ratio from which it fades at full strength; the ramp avoids jumps while the camera moves. */
const DEEP = 4;
/** The full strength. */
const STRENGTH = 0.7;

/**
 * The strength of `depthFade: 'auto'`: 0 if the visible depth is at most three times the shorter side of the sheet at the scene's
 * middle. The middle is half way from front to back on the sheet: for a railway that is not half its length.
 */
export function automaticDepthFade({ front, back }: SeenDepths, camera: Camera): number {
  const { elements } = camera.projectionMatrix;
  const { view } = camera as ViewedCamera;
  const [x, y] = view?.enabled ? [view.width / view.fullWidth, view.height / view.fullHeight] : [1, 1];
  const isOrthographic = elements[15] === 1;
  const middle = isOrthographic ? 1 : (2 * front * back) / (front + back);
  const side = Math.min(2 / (Math.abs(elements[0]) * x), 2 / (Math.abs(elements[5]) * y)) * middle;
  const depth = (back - front) / side;
  return STRENGTH * Math.min(Math.max((depth - DEEP_FROM) / (DEEP - DEEP_FROM), 0), 1);
}
