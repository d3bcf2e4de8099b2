import type { ModelFile } from '../../files/readModel.js';
import type { SavedView } from '../../settings/savedViews.js';
import { SETTING_KEYS, type Settings } from '../../settings/settings.js';
import type { ViewState } from '../../stage/view/View.js';

/** A drawing but for its model. */
export interface LookState {
  settings: Settings;
  /** Undefined if the model is to be framed. */
  camera: ViewState | undefined;
  views: readonly SavedView[];
}

/** What Undo goes back to. */
export interface DrawingState extends LookState {
  /** Of the user's own model. */
  files: readonly ModelFile[] | undefined;
}

export const isSameState = (a: DrawingState, b: DrawingState): boolean =>
  SETTING_KEYS.every((key) => a.settings[key] === b.settings[key]) &&
  a.files === b.files &&
  JSON.stringify(a.views) === JSON.stringify(b.views) &&
  // Framed is framed, whatever the shape of the page was.
  ((isFramed(a) && isFramed(b)) || JSON.stringify(a.camera) === JSON.stringify(b.camera));

const isFramed = ({ camera }: DrawingState): boolean => camera === undefined || camera.framedFor !== undefined;
