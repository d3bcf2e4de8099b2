import type { Hand, HandNumbers, HandStroke } from 'three-hatching';
import type { ModelFile } from '../../viewer/files/readModel.js';
import type { SavedView } from '../../viewer/settings/CameraView.js';
import { SETTING_KEYS, type Settings } from '../../viewer/settings/settings.js';
import { isSameChoice, type ModelChoice } from '../../viewer/settings/shareLink.js';
import type { ViewState } from '../viewport/View.js';

/** The user's own hand so far. Immutable, because Undo returns to earlier ones. */
export interface OwnHand {
  /** The strokes on the sheet, as drawn. */
  readonly strokes: readonly HandStroke[];
  /** The hand learnt from them, with the user's changes; undefined while there are too few strokes. */
  readonly hand: Hand | undefined;
  /**
   * The numbers changed by the user, which stay when more strokes are drawn; undefined for a hand that was read, where they are unknown.
   */
  readonly changed: Partial<HandNumbers> | undefined;
  /** The hand as text for a link; undefined if too long. For a hand from a link, the only known field until it is read. */
  readonly link: string | undefined;
  /** The hand as a file, stored with the drawing. */
  readonly files: readonly ModelFile[] | undefined;
}

/** A hand from a link that has not been read yet. */
export const linkedHand = (link: string | undefined): OwnHand | undefined =>
  link === undefined ? undefined : { strokes: [], hand: undefined, changed: undefined, link, files: undefined };

/** The file name of a hand. */
export const HAND_FILE = 'hand.json';

/** The state of a drawing without its model. */
export interface LookState {
  settings: Settings;
  /** Undefined to frame the model. */
  camera: ViewState | undefined;
  views: readonly SavedView[];
  /** The user's own hand, if there is one, in use or not. */
  hand: OwnHand | undefined;
}

/** The state of a drawing that Undo restores. */
export interface DrawingState extends LookState {
  /** The files of the model, if it is the user's own. */
  files: readonly ModelFile[] | undefined;
  /** What is selected of its file. */
  choice: ModelChoice;
}

export const isSameState = (a: DrawingState, b: DrawingState): boolean =>
  SETTING_KEYS.every((key) => a.settings[key] === b.settings[key]) &&
  a.files === b.files &&
  isSameChoice(a.choice, b.choice) &&
  isSameHand(a.hand, b.hand) &&
  JSON.stringify(a.views) === JSON.stringify(b.views) &&
  // A framed model is framed again in every viewport, so its camera is ignored.
  ((isFramed(a) && isFramed(b)) || JSON.stringify(a.camera) === JSON.stringify(b.camera));

/** A hand from a link becomes another object when it is read. */
const isSameHand = (a: OwnHand | undefined, b: OwnHand | undefined): boolean =>
  a === b || (a?.link !== undefined && a.link === b?.link);

const isFramed = ({ camera }: DrawingState): boolean => camera === undefined || camera.framedFor !== undefined;
