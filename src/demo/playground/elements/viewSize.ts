import type { DrawnView } from '../../print/printPlan.js';
import type { Stage } from '../../stage/Stage.js';
import { page } from './page.js';

/** Size of the page's view, in CSS pixels. */
export function viewSize(): { width: number; height: number } {
  const { clientWidth: width, clientHeight: height } = page.viewport;
  return { width, height };
}

/** Between this and its inverse, a model is about as wide as high: a sheet for it may be turned either way. */
const SQUARE = 1.15;

/** The page's view, and how a sheet for what is in it is turned: as the model, or as the page. */
export function drawnView({ view: { proportion } }: Stage): DrawnView {
  const size = viewSize();
  const isSquare = Math.max(proportion, 1 / proportion) < SQUARE;
  return { ...size, isWide: isSquare ? size.width > size.height : proportion > 1 };
}
