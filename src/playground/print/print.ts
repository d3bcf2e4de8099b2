import { type PerspectiveCamera, Vector3 } from 'three';
import { type PrintPlan, toMillimetres } from './printPlan.js';

export { ZipWriter } from './BlobWriter.js';
/** The functions for drawing pictures, fetched when the first picture is saved. */
export { cutToDrawing, drawPicture } from './drawPicture.js';
export { type PrintPlan, planPrint, sheetOnView } from './printPlan.js';
export { planSvg, printablePlan, type SvgPlan } from './svgPlan.js';

/** Describes the size of a picture. */
export function describePrint({ width, height, dpi }: PrintPlan): string {
  const [wide, high] = [width, height].map((pixels) => Math.round(toMillimetres(pixels, dpi)));
  return `${width.toLocaleString('en')} × ${height.toLocaleString('en')} px, ${wide} × ${high} mm, ${dpi.toLocaleString('en')} dpi`;
}

/**
 * Pixels per radius of the model at its nearest point.
 *
 * @param camera of the whole view, which looks at a model of radius 1 around the origin
 */
export function nearestRadius(camera: PerspectiveCamera, { viewHeight }: Pick<PrintPlan, 'viewHeight'>): number {
  const scale = 0.5 * viewHeight * camera.projectionMatrix.elements[5];
  if ('isOrthographicCamera' in camera) return scale;
  const depth = -camera.position.dot(camera.getWorldDirection(new Vector3()));
  return scale / Math.max(depth - 1, camera.near);
}
