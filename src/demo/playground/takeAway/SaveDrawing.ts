import type { Report } from '../../drawing/Report.js';
import type { Settings } from '../../settings/settings.js';
import type { Stage } from '../../stage/Stage.js';

/**
 * Draws what is saved, and hands it to the browser.
 *
 * @param name of the file, without its extension
 * @returns what was saved, in a sentence; or what was drawn
 * @throws Error with a sentence for the user
 */
export type SaveDrawing<Result = string> = (
  stage: Stage,
  settings: Settings,
  name: string,
  report: Report,
  signal: AbortSignal,
) => Promise<Result>;
