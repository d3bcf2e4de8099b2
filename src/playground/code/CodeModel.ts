import type { CameraView } from '../../viewer/settings/CameraView.js';
import type { Settings } from '../../viewer/settings/settings.js';

/** The model that copied code is to draw. */
export interface CodeModel {
  /** The setting `model`: a built-in model, or a file that the user opened. */
  model: Settings['model'];
  /** The name in the caption; of a file that the user opened, the name of the main file. */
  title: string;
  /** The radius of a model that is drawn as a scene, before it was fitted; undefined for one mesh. */
  sceneRadius: number | undefined;
  /** Whether its surfaces are drawn from both sides, whatever its file says. */
  isOpen: boolean;
  /** Of a scene, how it is moved to the middle and scaled to a radius of 1. The code measures a single mesh itself. */
  place?: { scale: number; position: [number, number, number] } | undefined;
  /** Of a scene, the clip that it is posed by, the time in the clip in seconds, and whether it is playing. */
  clip?: { index: number; time: number; isPlaying: boolean } | undefined;
}

/** A drawing as copied code makes it: a model in a look, seen from a place. */
export interface CodeDrawing {
  model: CodeModel;
  settings: Settings;
  camera: CameraView;
  /** The height of a ground under the model. */
  groundHeight: number;
  /** The width of the picture divided by its height. */
  aspect: number;
}
