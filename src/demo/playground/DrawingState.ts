import type { ModelFile } from '../files/readModel.js';
import type { CameraView } from '../settings/CameraView.js';
import { SETTING_KEYS, type Settings } from '../settings/settings.js';

/** What Undo goes back to. */
export interface DrawingState {
  settings: Settings;
  /** Undefined if the model was framed. */
  camera: CameraView | undefined;
  /** Of the user's own model. */
  files: readonly ModelFile[] | undefined;
}

export const isSameState = (a: DrawingState, b: DrawingState): boolean =>
  SETTING_KEYS.every((key) => a.settings[key] === b.settings[key]) &&
  a.files === b.files &&
  JSON.stringify(a.camera) === JSON.stringify(b.camera);
