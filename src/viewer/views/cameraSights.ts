import { Matrix4, Ray, Triangle, Vector3 } from 'three';
import { counted } from '../files/common/ModelError.js';
import type { FileCamera } from '../files/common/ModelExtras.js';
import type { ViewTriangles } from './viewSurface.js';

/** What a camera sees: the model, nothing of it, or the wall around it from within. */
export type CameraSight = 'model' | 'nothing' | 'wall';

/** Rays across the width and the height of a picture. */
const RAYS = 32;
/** Backs that are nearer than this are those of a wall around the camera, if most rays meet them. In radii of the model. */
const WALL = 0.1;
const MOST = 0.5;

/**
 * Finds what the cameras of a file see.
 *
 * @param triangles of a model of radius 1
 * @param cameras in the space of the triangles
 */
export const cameraSights = (triangles: ViewTriangles, cameras: readonly FileCamera[]): CameraSight[] =>
  cameras.map((camera) => sightOf(triangles, camera));

/** The cameras that see the model, and notes on the others. */
export function sightedCameras(
  cameras: readonly FileCamera[],
  sights: readonly CameraSight[],
): { cameras: FileCamera[]; details: string[] } {
  const count = (wanted: CameraSight): number => sights.filter((sight) => sight === wanted).length;
  const details = [
    counted(count('nothing'), 'camera', 'left out, from which nothing of the model is seen'),
    counted(count('wall'), 'camera', 'left out, inside a wall'),
  ];
  return { cameras: cameras.filter((_, i) => sights[i] === 'model'), details: details.filter(Boolean) };
}

/** The nearest surfaces along the rays of a camera, row by row from the lower left. */
interface Picture {
  depths: Float64Array;
  isBack: Uint8Array;
}

function sightOf({ positions, indices, isSingleSided }: ViewTriangles, camera: FileCamera): CameraSight {
  const picture = { depths: new Float64Array(RAYS * RAYS).fill(Infinity), isBack: new Uint8Array(RAYS * RAYS) };
  const toCamera = cameraSpace(camera);
  const triangle = new Triangle();
  // Camera space is mirrored, and the swapped corners turn triangles back.
  const corners = [triangle.a, triangle.c, triangle.b];
  const count = Math.floor((indices?.length ?? positions.length / 3) / 3);
  for (let number = 0; number < count; number++) {
    for (let k = 0; k < 3; k++) {
      const vertex = 3 * (indices ? indices[3 * number + k] : 3 * number + k);
      corners[k].set(positions[vertex], positions[vertex + 1], positions[vertex + 2]).applyMatrix4(toCamera);
    }
    enter(picture, triangle, camera.isOrthographic, isSingleSided?.[number] === 1);
  }
  const { depths, isBack } = picture;
  if (depths.every((depth) => depth === Infinity)) return 'nothing';
  const walled = depths.filter((depth, ray) => isBack[ray] === 1 && depth < WALL).length;
  return walled > MOST * depths.length ? 'wall' : 'model';
}

/** The matrix to a space in which z is the depth, and the picture reaches from −1 to 1 along x and y, at depth 1 if it has perspective. */
function cameraSpace({ position, forwards, up, high, aspect = 1 }: FileCamera): Matrix4 {
  const forth = new Vector3(...forwards);
  const right = new Vector3(...forwards).cross(new Vector3(...up)).normalize();
  const above = right.clone().cross(forth).divideScalar(high);
  right.divideScalar(high * aspect);
  const away = new Matrix4().makeTranslation(-position[0], -position[1], -position[2]);
  return new Matrix4().makeBasis(right, above, forth).transpose().multiply(away);
}

const ray = new Ray();
const hit = new Vector3();
const normal = new Vector3();

/** Enters a triangle of camera space in a picture, where nothing is nearer. */
function enter({ depths, isBack }: Picture, triangle: Triangle, isFlat: boolean, hidesBack: boolean): void {
  const { a, b, c } = triangle;
  if (!(Math.max(a.z, b.z, c.z) > 0)) return;
  const columns = pixelsOf(triangle, 'x', isFlat);
  const rows = pixelsOf(triangle, 'y', isFlat);
  if (!(columns.first <= columns.last && rows.first <= rows.last)) return;
  triangle.getNormal(normal);
  for (let row = rows.first; row <= rows.last; row++) {
    for (let column = columns.first; column <= columns.last; column++) {
      const [x, y] = [middleOf(column), middleOf(row)];
      ray.origin.set(isFlat ? x : 0, isFlat ? y : 0, 0);
      ray.direction.set(isFlat ? 0 : x, isFlat ? 0 : y, 1);
      const at = row * RAYS + column;
      if (!ray.intersectTriangle(a, b, c, hidesBack, hit) || !(hit.z < depths[at])) continue;
      depths[at] = hit.z;
      isBack[at] = Number(normal.dot(ray.direction) > 0);
    }
  }
}

const middleOf = (pixel: number): number => (2 * pixel + 1) / RAYS - 1;

/** The pixels whose middles a triangle may cover along an axis: all, if it reaches behind the eye. */
function pixelsOf({ a, b, c }: Triangle, axis: 'x' | 'y', isFlat: boolean): { first: number; last: number } {
  if (!isFlat && !(Math.min(a.z, b.z, c.z) > 0)) return { first: 0, last: RAYS - 1 };
  const places = [a, b, c].map((corner) => (((isFlat ? corner[axis] : corner[axis] / corner.z) + 1) * RAYS - 1) / 2);
  return {
    first: Math.max(0, Math.ceil(Math.min(...places))),
    last: Math.min(RAYS - 1, Math.floor(Math.max(...places))),
  };
}
