import { type PrintPlan, toMillimetres } from './printPlan.js';

/** Everything that drawing a picture needs. It is fetched when the first picture is saved. */
export { cutToDrawing, drawPicture } from './drawPicture.js';
export { nearestRadius } from './nearestRadius.js';
export { type PrintPlan, planPrint, sheetOnView } from './printPlan.js';
export { planSvg, printablePlan, type SvgPlan } from './svgPlan.js';
export { ZipWriter } from './ZipWriter.js';

/** The size of a picture in words. */
export function describePrint({ width, height, dpi }: PrintPlan): string {
  const [wide, high] = [width, height].map((pixels) => Math.round(toMillimetres(pixels, dpi)));
  return `${width.toLocaleString('en')} × ${height.toLocaleString('en')} px, ${wide} × ${high} mm, ${dpi.toLocaleString('en')} dpi`;
}
