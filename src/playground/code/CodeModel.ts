import type { CameraView } from '../../viewer/settings/CameraView.js';
import type { Settings } from '../../viewer/settings/settings.js';

/** The model that copied code is to draw. */
export interface CodeModel {
  model: Settings['model'];
  /** The name in the caption; of a file that the user opened, the name of the main file. */
  title: string;
  /** The radius of a model that is drawn as a scene, before it was fitted; undefined for one mesh. */
  sceneRadius: number | undefined;
  /** Whether its surfaces are drawn from both sides, whatever its file says. */
  isOpen: boolean;
  /** How a scene is moved to the middle and scaled to a radius of 1. The code measures a single mesh itself. */
  place?: { scale: number; position: [number, number, number] } | undefined;
  /** The clip that poses a scene, and the time in the clip in seconds. */
  clip?: { index: number; time: number; isPlaying: boolean } | undefined;
}

/** A drawing as copied code makes it. `aspect` is the width of the picture divided by its height. */
export interface CodeDrawing {
  model: CodeModel;
  settings: Settings;
  camera: CameraView;
  groundHeight: number;
  aspect: number;
}
