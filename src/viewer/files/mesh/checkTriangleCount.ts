import { ModelError } from '../common/ModelError.js';

/** Bytes per triangle while a mesh is read: vertices, corners, and the room in which their arrays grow. */
const BYTES_PER_READ_TRIANGLE = 50;
/** The memory that a page can get for one model, besides the copies held while it is read and baked, in bytes. */
const MAX_BYTES = 2 ** 30;
/** Bytes per triangle of a large baked mesh: layout `pull`, with normals, colours and line data. Measured on a million triangles. */
const BYTES_PER_TRIANGLE = 205;
/** Rounded, since messages show it. */
const MAX_TRIANGLES = Math.floor(MAX_BYTES / BYTES_PER_TRIANGLE / 1e5) * 1e5;

/** Whether memory suffices to draw this many triangles. */
export const canDraw = (triangles: number): boolean => triangles <= MAX_TRIANGLES;

const MAX_READ_TRIANGLES = Math.floor(MAX_BYTES / BYTES_PER_READ_TRIANGLE / 1e6) * 1e6;

/** @throws ModelError if there are no triangles, or more than can be read before simplification */
export const checkReadTriangles = (triangles: number): void => checkCount(triangles, MAX_READ_TRIANGLES);

/** @throws ModelError if there are no triangles, or more than can be drawn */
export const checkTriangleCount = (triangles: number): void => checkCount(triangles, MAX_TRIANGLES);

function checkCount(triangles: number, most: number): void {
  if (!(triangles > 0)) {
    throw new ModelError('The file holds no triangles; only surfaces can be hatched, not points or lines.');
  }
  if (triangles > most) {
    throw new ModelError(
      `The model has more than ${most.toLocaleString('en')} triangles, for which a page has no memory.`,
    );
  }
}
