import type { Report } from '../../viewer/drawing/buildModel.js';
import type { Settings } from '../../viewer/settings/settings.js';
import type { Viewport } from '../viewport/Viewport.js';

/**
 * A function that draws a picture or a video, and downloads it unless the caller takes the result.
 *
 * @param name file name without extension
 * @returns a sentence about what was saved, or the result
 * @throws Error with a sentence for the user
 */
export type SaveDrawing<Result = string> = (
  viewport: Viewport,
  settings: Settings,
  name: string,
  report: Report,
  signal: AbortSignal,
) => Promise<Result>;
