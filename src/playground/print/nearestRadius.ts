import { type PerspectiveCamera, Vector3 } from 'three';
import type { PrintPlan } from './printPlan.js';

/**
 * How many pixels of a picture a radius of the model is where it is nearest.
 *
 * @param camera of the whole view, turned to a model that lies about the origin, with a radius of 1
 */
export function nearestRadius(camera: PerspectiveCamera, { viewHeight }: Pick<PrintPlan, 'viewHeight'>): number {
  const scale = 0.5 * viewHeight * camera.projectionMatrix.elements[5];
  if ('isOrthographicCamera' in camera) return scale;
  const depth = -camera.position.dot(camera.getWorldDirection(new Vector3()));
  return scale / Math.max(depth - 1, camera.near);
}
