/**
 * Vector drawings for print and plotters.
 *
 * @module three-hatching/svg
 */
export type { DrawSVGOptions } from './DrawSVGOptions.js';
export { drawSVG, type SVGDrawing } from './drawSVG.js';
export type { LeftOut } from './leftOut.js';
export type { SheetName } from './sheetSizes.js';
