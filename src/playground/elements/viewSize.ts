import { ABOUT_SQUARE } from '../../viewer/sceneSetup/framing.js';
import type { DrawnView } from '../print/printPlan.js';
import type { Viewport } from '../viewport/Viewport.js';
import { page } from './page.js';

/** The size of the viewport in CSS pixels. */
export function viewSize(): { width: number; height: number } {
  const { clientWidth: width, clientHeight: height } = page.viewport;
  return { width, height };
}

/** The viewport's size, and the orientation of a sheet that suits the model; if either does, that of the viewport. */
export function drawnView({ view: { proportion } }: Viewport): DrawnView {
  const size = viewSize();
  const isSquare = Math.max(proportion, 1 / proportion) < ABOUT_SQUARE;
  return { ...size, isWide: isSquare ? size.width > size.height : proportion > 1 };
}
