import { MathUtils, Vector3 } from 'three';
import type { FileCamera } from '../files/common/ModelExtras.js';
import type { CameraView } from '../settings/CameraView.js';
import { plainName } from '../settings/plainName.js';
import { isCamera, MAX_VIEWS, type SavedView } from '../settings/savedViews.js';
import { LENS } from './createCamera.js';

type Light = SavedView['light'];

/** A camera that looks at the model from within a sphere around it stays where it is; others keep the size of what they look at. */
const WITHIN = 1;
const LEAST_DISTANCE = 0.1;

/**
 * Views of a file: one of each camera and, if it has lights, one with these and one with the light that suits the view.
 *
 * @param cameras in the world, where the model of radius 1 lies around the origin
 * @param light at present
 * @param found the light that suits the view, if that of the file is another
 * @returns no more views than have keys, and how many cameras have none
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

/** A view with the lens of the page, which shows what a camera looks at in the size in which that does; undefined if it is too far away. */
function cameraViewOf({ position, forwards, high, isOrthographic }: FileCamera): CameraView | undefined {
  const eye = new Vector3().fromArray(position);
  const way = new Vector3().fromArray(forwards);
  const distance = Math.max(LEAST_DISTANCE, -eye.dot(way));
  const target = eye.clone().addScaledVector(way, distance);
  const half = isOrthographic ? high : high * distance;
  const away = half / Math.tan(MathUtils.degToRad(LENS.fieldOfView) / 2);
  if (isOrthographic || eye.length() > WITHIN) eye.copy(target).addScaledVector(way, -away);
  const numbers = [...eye.toArray(), ...target.toArray()].map(Math.fround);
  if (!isCamera(numbers)) return undefined;
  const [x, y, z, tx, ty, tz] = numbers;
  return { position: [x, y, z], target: [tx, ty, tz] };
}
