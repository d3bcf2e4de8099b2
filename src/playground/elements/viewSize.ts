import { ABOUT_SQUARE } from '../../viewer/sceneSetup/framing.js';
import type { DrawnView } from '../print/printPlan.js';
import type { Viewport } from '../viewport/Viewport.js';
import { page } from './page.js';

/** The size of the viewport in CSS pixels. */
export function viewSize(): { width: number; height: number } {
  const { clientWidth: width, clientHeight: height } = page.viewport;
  return { width, height };
}

/** The viewport, and the orientation of a sheet for the model: that of the model or, if the model suits either, of the viewport. */
export function drawnView({ view: { proportion } }: Viewport): DrawnView {
  const size = viewSize();
  const isSquare = Math.max(proportion, 1 / proportion) < ABOUT_SQUARE;
  return { ...size, isWide: isSquare ? size.width > size.height : proportion > 1 };
}
