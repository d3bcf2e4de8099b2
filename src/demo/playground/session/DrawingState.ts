import type { ModelFile } from '../../../files/readModel.js';
import type { SavedView } from '../../../settings/savedViews.js';
import { SETTING_KEYS, type Settings } from '../../../settings/settings.js';
import type { ViewState } from '../../stage/view/View.js';

/** The state of a drawing without its model. */
export interface LookState {
  settings: Settings;
  /** Undefined if the model is to be framed. */
  camera: ViewState | undefined;
  views: readonly SavedView[];
}

/** The state of a drawing that Undo restores. */
export interface DrawingState extends LookState {
  /** The files of the model, if it is the user's own. */
  files: readonly ModelFile[] | undefined;
}

export const isSameState = (a: DrawingState, b: DrawingState): boolean =>
  SETTING_KEYS.every((key) => a.settings[key] === b.settings[key]) &&
  a.files === b.files &&
  JSON.stringify(a.views) === JSON.stringify(b.views) &&
  // A framed model is placed anew in every viewport, so its camera does not matter.
  ((isFramed(a) && isFramed(b)) || JSON.stringify(a.camera) === JSON.stringify(b.camera));

const isFramed = ({ camera }: DrawingState): boolean => camera === undefined || camera.framedFor !== undefined;
