import type { FileCamera } from '../files/common/ModelExtras.js';
import type { CameraView } from '../settings/CameraView.js';
import { inSingle, isCamera } from '../settings/cameraNumbers.js';
import { MAX_VIEWS, plainName, type SavedView } from '../settings/savedViews.js';
import { viewOfCamera } from './placeCamera.js';

type Light = SavedView['light'];

/**
 * Views of a file: one per camera and, if it has lights, one with these and one with the light found for the view.
 *
 * @param cameras in the world, where the model of radius 1 lies around the origin
 * @param light at present
 * @param found the light chosen for the view, if it differs from the file's
 * @returns at most {@link MAX_VIEWS} views, and the number of cameras left out
 */
export function viewsOfFile(
  cameras: readonly FileCamera[],
  light: Light,
  found: Light | undefined,
): { views: SavedView[]; leftOut: number } {
  const lit: SavedView[] = found
    ? [
        { name: 'Lights of the file', camera: undefined, light },
        { name: 'Light for the view', camera: undefined, light: found },
      ]
    : [];
  const seen = cameras.flatMap((camera, i): SavedView[] => {
    const view = cameraViewOf(camera);
    return view ? [{ name: plainName(camera.name) || `Camera ${i + 1}`, camera: view, light }] : [];
  });
  const views = [...lit, ...seen].slice(0, MAX_VIEWS);
  return { views, leftOut: lit.length + cameras.length - views.length };
}

/** A view through a file camera's lens; undefined if the camera is too far away. */
function cameraViewOf(camera: FileCamera): CameraView | undefined {
  const view = inSingle(viewOfCamera(camera));
  return isCamera(view) ? view : undefined;
}
