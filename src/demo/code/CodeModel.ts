import type { CameraView } from '../settings/CameraView.js';
import type { Settings } from '../settings/settings.js';

/** The model that copied code is to draw. */
export interface CodeModel {
  /** The setting: a built-in model, or a file of the user's own. */
  model: Settings['model'];
  /** The name in the caption; that of the main file, of a user's own model. */
  title: string;
  /** The radius of a model that is drawn as a scene, before it was fitted; undefined for one mesh. */
  sceneRadius: number | undefined;
  /** Whether its surfaces are drawn from both sides, whatever its file says. */
  isOpen: boolean;
  /** Of a scene: what moves and scales it to the middle, with a radius of 1. One mesh is measured by the code itself. */
  place?: { scale: number; position: [number, number, number] } | undefined;
  /** Of a scene: the clip that it is posed by, its time in seconds, and whether it is playing. */
  clip?: { index: number; time: number; isPlaying: boolean } | undefined;
}

/** What a copied page draws: a model, in a look, seen from a place. */
export interface CodeDrawing {
  model: CodeModel;
  settings: Settings;
  camera: CameraView;
  /** The height of a ground under the model. */
  groundHeight: number;
  /** Width of the picture per height. */
  aspect: number;
}
