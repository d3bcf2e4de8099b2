/**
 * Vector drawings for print and plotters.
 *
 * @module three-hatching/svg
 */

export type { PenLayers, PenPart } from '../plot/pens.js';
export { type PlotterName, type PlotterSpeeds, plottingTime } from '../plot/plotTime.js';
export type { SurfaceLines } from '../streamlines/SurfaceLines.js';
export type { DrawSVGOptions, PlotterPen } from './DrawSVGOptions.js';
export { drawSVG, type SVGDrawing, type SVGDrawingLayer } from './drawSVG.js';
export type { LeftOut } from './leftOut.js';
export type { SheetName } from './sheetSizes.js';
